// Light of an environment that arrives at surfaces through the medium: on a grid, and as the paper
// has it, beside unbiased Monte Carlo.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/scene/environment.h"
#include "core/scene/radiance_map.h"
#include "core/transport/average_depth.h"
#include "render/environment_light.h"
#include "render/environment_source.h"
#include "render/reference/surface_reference.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

struct Place {
  glm::dvec3 position, normal;
};

// Points of a ball, seen from outside, small enough to be one point of the medium.
std::vector<Place> around(const glm::dvec3& middle, double radius, int count) {
  Random random(5);
  std::vector<Place> places;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 n = glm::normalize(random.point(1.0));
    places.push_back({middle + radius * n, n});
  }
  return places;
}

// Errors of what a white surface reflects there, relative rms over places and channels.
struct Errors {
  double grid = 0.0;
  double average = 0.0;  // with the average optical depth, eq. 27
};
Errors errors(const Scene& scene, const std::vector<Place>& places,
              const SourceGridSize& size = {}) {
  const EnvironmentLight light(*scene.environment, ScatterTable::distant());
  ArrivalOptics optics;
  optics.anisotropy = scene.optics.anisotropy;
  Box box{places[0].position, places[0].position};
  for (const Place& place : places) {
    box.low = glm::min(box.low, place.position);
    box.high = glm::max(box.high, place.position);
  }
  EnvironmentSource source;
  EXPECT_TRUE(source.update({*scene.environment, scene.medium, scene.optics.anisotropy, 0.0,
                             SourceGrid::Receivers{box, optics}, size},
                            Job{}));
  Surface white;
  white.material.reflectance = glm::dvec3(1.0);
  double truth2 = 0.0;
  double grid2 = 0.0;
  double average2 = 0.0;
  for (const Place& place : places) {
    SurfacePoint point;
    point.position = place.position;
    point.normal = point.to_eye = place.normal;
    point.surface = &white;
    const ReflectedLight reference =
        reflected_light(scene, Visibility({}), point, {.samples = 1'000});
    const glm::dvec3 truth = reference.attenuated + reference.scattered;
    const ArrivingLight arriving = SourceLookUp(source.grid(), place.position).arriving({});
    const glm::dvec3 grid(light.diffuse(place.normal, arriving));
    const auto Tbar = static_cast<float>(average_depth(scene.medium, 0.0, place.position));
    const glm::dvec3 average(light.diffuse(place.normal, light.arriving(Tbar, 1.0)));
    truth2 += glm::dot(truth, truth);
    grid2 += glm::dot(grid - truth, grid - truth);
    average2 += glm::dot(average - truth, average - truth);
  }
  return {std::sqrt(grid2 / truth2), std::sqrt(average2 / truth2)};
}

Scene cloud_under(std::shared_ptr<const RadianceMap> map, double depth, double g = 0.0) {
  Scene scene = cloud_scene(30, depth);
  scene.lights.clear();
  scene.optics.anisotropy = g;
  scene.environment.emplace().map = std::move(map);
  return scene;
}

// The bounds are what was measured and a third more; up to a half of that is the noise of the Monte
// Carlo. Behind dense clouds and at their edge the grid's light spreads sideways.
TEST(ArrivingLight, IsTheReferenceInClouds) {
  struct Row {
    const char* what;
    Scene scene;
    std::vector<Place> places;
    double grid, average;
  };
  const std::vector<Place> inside = around({0, 0, 0}, 0.1, 8);
  const std::vector<Place> edge = around({0.7, 0.3, 0}, 0.1, 8);
  const std::vector<Place> below = around({0, -2, 0}, 0.1, 8);
  const auto even = constant_sky(1.0f);
  const Row rows[] = {
      {"thin, inside", cloud_under(even, 0.5), inside, 0.005, 0.006},
      {"thin, below", cloud_under(even, 0.5), below, 0.006, 0.003},
      {"inside", cloud_under(even, 2.0), inside, 0.02, 0.07},
      {"edge", cloud_under(even, 2.0), edge, 0.017, 0.07},
      {"below", cloud_under(even, 2.0), below, 0.012, 0.02},
      {"dense, inside", cloud_under(even, 10.0), inside, 0.07, 0.7},
      {"dense, edge", cloud_under(even, 10.0), edge, 0.12, 0.6},
      {"dense, below", cloud_under(even, 10.0), below, 0.06, 0.06},
      {"inside, brighter above", cloud_under(smooth_sky(), 2.0), inside, 0.02, 0.13},
      {"scattering forwards", cloud_under(even, 2.0, 0.6), inside, 0.03, 0.1},
      {"scattering backwards", cloud_under(even, 2.0, -0.6), inside, 0.04, 0.06},
  };
  for (const Row& row : rows) {
    const Errors got = errors(row.scene, row.places);
    EXPECT_LT(got.grid, row.grid) << row.what;
    EXPECT_GT(got.average, row.average) << row.what;
  }
}

// Section 7 of the paper names what it gets wrong: a dense cloud behind the receiver counts in the
// average as much as one in front of it.
TEST(ArrivingLight, KnowsThatADenseCloudIsBehindTheReceiver) {
  for (const auto& map : {constant_sky(1.0f), smooth_sky()}) {
    Scene scene;
    scene.environment.emplace().map = map;
    scene.medium.append({{0, 0, 0}, 1.0, 10.0});
    const Errors behind = errors(scene, {{{0, 1.5, 0}, {0, 1, 0}}, {{1.5, 0, 0}, {1, 0, 0}}});
    EXPECT_LT(behind.grid, 0.015);
    EXPECT_GT(behind.average, 0.75);
    const Errors before = errors(scene, {{{0, 1.5, 0}, {0, -1, 0}}, {{1.5, 0, 0}, {-1, 0, 0}}});
    EXPECT_LT(before.grid, 0.08);
    EXPECT_GT(before.average, 0.2);
  }
}

TEST(ArrivingLight, ConvergesAsTheGridGrows) {
  const Scene scene = cloud_under(constant_sky(1.0f), 10.0);
  const std::vector<Place> below = around({0, -2, 0}, 0.1, 8);
  const double coarse = errors(scene, below, {.nodes = 5'000, .directions = 96}).grid;
  const double fine = errors(scene, below, {.nodes = 300'000, .directions = 96}).grid;
  EXPECT_LT(fine, 0.5 * coarse);
}

}  // namespace
}  // namespace brume
