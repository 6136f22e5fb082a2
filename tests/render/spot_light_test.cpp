// Spot lights, as every method sees them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "brume/frame.h"
#include "core/scene/camera_rays.h"
#include "core/scene/fields/light_fields.h"
#include "core/transport/optical_depth.h"
#include "tests/render/test_profiles.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Scene lit_by_spot(const light::Spot& cone, double depth = 1.0) {
  Scene scene = on_film(cloud_scene(30, depth), {32, 24});
  scene.lights = {{{0.9, 1.4, 0.6}, {6.0, 5.0, 4.0}, cone}};
  return scene;
}

// Towards the middle of the cloud, across the view.
const glm::dvec3 towards_cloud(-0.9, -1.4, -0.6);
const light::Spot smooth{towards_cloud, 5.0, 20.0};
const light::Spot sharp{{-0.9, -1.2, -0.7}, 11.8, 12.0};
const light::Spot wide{{-0.2, 1.0, 0.1}, 60.0, 130.0};

// The integral of the radiance that a ray of the camera scatters, by small steps.
double integral(const Scene& scene, const glm::dvec3& w, double begin, double end) {
  const Light& light = scene.lights[0];
  const light::Spot& cone = *light.as<light::Spot>();
  const double dark = std::cos(glm::radians(cone.outer_angle));
  const double slope = std::max(std::cos(glm::radians(cone.inner_angle)) - dark, 1e-9);
  const auto depth = [&](const glm::dvec3& from, const glm::dvec3& to) {
    const double r = glm::length(to - from);
    return scene.medium.homogeneous_density() * r +
           plain_depth(scene.medium, from, (to - from) / r, r);
  };
  constexpr int steps = 16000;
  const double step = (end - begin) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const glm::dvec3 x = scene.camera.eye + (begin + step * (i + 0.5)) * w;
    const glm::dvec3 q = x - light.position;
    const double r = glm::length(q);
    const double cosine = glm::dot(q / r, glm::normalize(cone.direction));
    const double share = std::clamp((cosine - dark) / slope, 0.0, 1.0);
    if (share == 0.0) continue;
    sum += share * share * plain_density(scene.medium, x) / (r * r) *
           std::exp(-depth(scene.camera.eye, x) - depth(light.position, x));
  }
  return light.intensity.x * sum * step / (4.0 * std::numbers::pi);
}

TEST(SpotLight, ReferenceIsTheIntegral) {
  for (const light::Spot& cone : {smooth, sharp, wide}) {
    Scene scene = in_fog(lit_by_spot(cone), 0.05);
    const Frame frame = render_frame(scene, reference_settings());
    const CameraRays rays(scene.camera, scene.film);
    for (const glm::ivec2 pixel : {glm::ivec2(16, 12), {13, 9}, {18, 6}, {20, 14}}) {
      const glm::dvec3 w = glm::normalize(rays.direction(pixel.x + 0.5, pixel.y + 0.5));
      const double expected = integral(scene, w, 0.0, 8.0) + integral(scene, w, 8.0, 100.0);
      const auto at = static_cast<std::size_t>(3 * (pixel.y * 32 + pixel.x));
      EXPECT_NEAR(frame.airlight[at], expected, 1e-3 * expected + 1e-7)
          << cone.outer_angle << " at " << pixel.x << ", " << pixel.y;
    }
  }
}

TEST(SpotLight, SlicedMatchesTheReference) {
  for (const light::Spot& cone : {smooth, sharp, wide}) {
    for (const double depth : {0.3, 3.0}) {
      for (const double b0 : {0.0, 0.05}) {
        Scene scene = in_fog(on_film(lit_by_spot(cone, depth), {16, 12}), b0);
        EXPECT_LT(airlight_error(scene, sliced(24), reference_settings()), 0.01)
            << cone.outer_angle << " depth " << depth << " b0 " << b0;
      }
    }
  }
}

// The lights of a street stand a few centimetres off some rays: slices span wide angles at them,
// over which cones and peaks of the phase function pass.
TEST(SpotLight, LightsBesideRaysMatchTheReference) {
  Scene scene = seen_by({{1.0, 1.7, 22.0}, {0.0, 3.0, -10.0}, {0.0, 1.0, 0.0}, 55.0}, {16, 12});
  scene.medium.set_homogeneous_density(0.03);
  const light::Spot downwards{{0.1, -1.0, 0.0}, 30.0, 70.0};
  light::Disk disk{.direction = {0.1, -1.0, 0.0}};
  disk.radius = 0.01;  // as good as a point
  for (const Light::Kind& kind :
       {Light::Kind(light::Point()), Light::Kind(downwards), Light::Kind(disk)}) {
    scene.lights.clear();
    for (const double z : {12.0, -2.0, -16.0}) {
      scene.lights.push_back({{z == -2.0 ? -5.0 : 5.0, 5.5, z}, glm::dvec3(80.0), kind});
    }
    for (const double g : {-0.7, 0.0, 0.5, 0.9}) {
      scene.optics.anisotropy = g;
      const Frame truth = render_frame(scene, reference_settings(1e-4));
      for (const auto& [slices, bound] : {std::pair(24, 0.015), {8, 0.05}}) {
        const Frame frame = render_frame(scene, sliced(slices));
        EXPECT_LT(rel_rmse(frame.airlight, truth.airlight), bound) << g;
      }
    }
  }
}

// Soft and hard edges; the film is the ray through the beam's axis. Within a slice the density is
// the mean, so it takes many of them.
TEST(SpotLight, NarrowBeamsAreTheIntegral) {
  for (const auto& [inner, outer] :
       {std::pair{2.9, 3.0}, {1.5, 1.9}, {0.5, 1.0}, {1.0, 1.0}, {0.02, 0.05}}) {
    Scene scene = on_film(lit_by_spot({towards_cloud, inner, outer}), {1, 1});
    scene.camera.vertical_fov = 0.01;
    const double distance = glm::length(scene.camera.target - scene.camera.eye);
    const double half_width = 0.1 * outer;
    const double expected = integral(scene, glm::normalize(scene.camera.target - scene.camera.eye),
                                     distance - half_width, distance + half_width);
    for (const auto& [settings, bound] :
         {std::pair(reference_settings(), 1e-3), {sliced(128), 0.02}}) {
      EXPECT_NEAR(render_frame(scene, settings).airlight[0], expected, bound * expected)
          << inner << " to " << outer;
    }
  }
}

// A white wall 10 u away is as bright on the axis, whatever the cone: I / (pi d^2).
TEST(SpotLight, NarrowSpotsAreFullOnTheirAxis) {
  for (const auto& [inner, outer] : {std::pair{20.0, 30.0},
                                     {2.9, 3.0},
                                     {1.5, 1.9},
                                     {0.5, 1.0},
                                     {0.4, 0.5},
                                     {0.3, 0.3},
                                     {0.02, 0.05}}) {
    Scene scene = seen_by({{0.0, 0.0, 9.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.001}, {1, 1});
    scene.surfaces = {wall(0.0, 10.0, 1.0)};
    scene.lights = {
        {{0.0, 0.0, 10.0}, glm::dvec3(1000.0), light::Spot{{0.0, 0.0, -1.0}, inner, outer}}};
    for (const Settings& settings : {sliced(24), reference_settings(), path_traced(4)}) {
      EXPECT_NEAR(render_frame(scene, settings).beauty[0], 10.0 / std::numbers::pi, 1e-3)
          << inner << " to " << outer;
    }
  }
}

TEST(SpotLight, OfAllDirectionsIsAPointLight) {
  const Scene spot = lit_by_spot({smooth.direction, 179.999, 180.0});
  Scene point = spot;
  point.lights[0].kind = light::Point();
  for (const Settings& settings : {reference_settings(), sliced(24), all_orders(24)}) {
    EXPECT_LT(
        rel_rmse(render_frame(spot, settings).airlight, render_frame(point, settings).airlight),
        1e-4);
  }
}

TEST(SpotLight, AllOrdersMatchPaths) {
  for (const light::Spot& cone : {smooth, wide}) {
    Scene scene = on_film(lit_by_spot(cone, 3.0), {16, 12});
    scene.surfaces = {wall(-1.2, 1.5)};
    expect_all_orders_match_paths(scene, "to " + std::to_string(cone.outer_angle) + " degrees");
  }
}

// A narrow beam far away keeps its power on a coarse grid.
TEST(SpotLight, NarrowBeamsAreNotLostBetweenNodes) {
  Scene scene = on_film(cloud_scene(5, 2.0), {12, 9});
  scene.lights = {{{0.0, 40.0, 0.0}, glm::dvec3(4000.0), light::Spot{{0.0, -1.0, 0.0}, 0.05, 0.1}}};
  const double expected = mean_airlight(scene, path_traced(4096));
  EXPECT_NEAR(mean_airlight(scene, all_orders(24)), expected, 0.05 * expected);
}

// By the paper, nothing shines but isotropic point lights; what is left out is counted.
TEST(PaperLights, AreIsotropicPointsOnly) {
  const Light point{{0.0, 2.0, 0.0}, glm::dvec3(3.0), light::Point()};
  Light profile = point;
  *profile_member(profile) = cosine_profile();
  Scene scene = lit_by_spot(smooth);
  const Light spot = scene.lights[0];
  const Light sun{{}, glm::dvec3(1.0), light::Directional{{0.0, -1.0, 0.0}}};
  const Light area{{0.0, 2.0, 0.0}, glm::dvec3(3.0), light::Rectangle()};
  // Far away it is one point.
  const Light ball{{16.0, 12.0, 9.0}, glm::dvec3(90.0), light::Sphere()};
  scene.lights = {point};
  const Frame expected = render_frame(scene, paper_settings);
  const std::string left_out = "isotropic point lights only; left out: ";
  EXPECT_FALSE(is_left_out(expected, left_out));
  scene.lights = {spot, profile, sun, area, ball, point};
  const Frame all = render_frame(scene, paper_settings);
  EXPECT_TRUE(is_left_out(all, left_out + "5"));
  EXPECT_EQ(all.airlight, expected.airlight);
  scene.lights = {spot, profile, sun, area, ball};
  EXPECT_EQ(std::ranges::max(render_frame(scene, paper_settings).airlight), 0.0f);
}

// Grazing, pointing away, closed, in the eye, inside a Gaussian, along a ray.
TEST(SpotLight, HardCasesAreFinite) {
  Scene scene = on_film(lit_by_spot(smooth, 5.0), {8, 6});
  scene.surfaces = {wall(-1.0, 2.0)};
  Settings small_grid = all_orders(8, {.nodes = 1000, .directions = 32});
  for (const glm::dvec3& position :
       {glm::dvec3(0.0), scene.camera.eye, glm::dvec3(0.0, 0.0, 2.0), glm::dvec3(0.0, 1e6, 0.0)}) {
    for (const glm::dvec3& direction :
         {glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1e12, 1e-12, 0.0)}) {
      for (const double outer : {1e-6, 0.5, 90.0, 180.0}) {
        scene.lights = {{position, glm::dvec3(3.0), light::Spot{direction, 0.0, outer}}};
        expect_finite(render_frame(scene, sliced(8)));
        expect_finite(render_frame(scene, small_grid));
        expect_finite(render_frame(scene, {.airlight = AirlightMethod::reference}));
      }
    }
  }
}

}  // namespace
}  // namespace brume
