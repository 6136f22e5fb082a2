// Unscattered light of point lights at the nodes of a grid.

#include "render/scattering/incident_point_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

using std::numbers::pi;

constexpr double spacing = 0.3;

// Of spherical harmonics, in one channel.
NodeLight incident_light(const PointSource& source, const glm::ivec3& count) {
  const GridNodes nodes{count, static_cast<float>(spacing)};
  NodePointLight light{source};
  light.intensity = {1.0f};
  NodeLight incident(grid_bands, 1, nodes.size());
  add_point_light(light, glm::dvec3(0.0), nodes, nullptr, incident, Job{});
  return incident;
}

// Of the first harmonic: what arrives from everywhere.
double arriving(const NodeLight& incident, std::size_t node) {
  return static_cast<double>(incident.row(0, 0)[node]) * 2.0 * std::sqrt(pi);
}

PointSource source_at(const glm::dvec3& position, const LightFalloff& falloff = {}) {
  PointSource source;
  source.position = position;
  source.falloff = falloff;
  return source;
}

struct NamedFalloff {
  std::string name;
  LightFalloff falloff;
};
const std::vector<NamedFalloff> falloffs{
    {"point", {}},
    {"spot", LightFalloff(light::Spot{{0.3, -1.0, 0.2}, 20.0, 50.0})},
    {"narrow spot", LightFalloff(light::Spot{{0.3, -1.0, 0.2}, 2.0, 5.0})},
    {"surface", LightFalloff::of_surface(glm::normalize(glm::dvec3(0.2, 0.1, -1.0)), false)}};

// Nodes 3 to 5 of a grid of 9 along each axis, and round positions among them: every tenth is on
// the lattice of a quarter of the spacing, or of an eighth, or off it by next to nothing.
std::vector<glm::dvec3> positions_beside_nodes(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(3.0, 5.0);
  std::vector<glm::dvec3> positions;
  for (int i = 0; i < count; ++i) {
    glm::dvec3 p(uniform(random), uniform(random), uniform(random));
    const double lattice = i % 2 == 0 ? 4.0 : 8.0;
    if (i % 5 != 0) p = glm::round(p * lattice) / lattice;
    if (i % 5 > 2) p += std::pow(10.0, -(3 + i % 6)) * glm::dvec3(1.0, -0.5, 0.3);
    positions.push_back(spacing * p);
  }
  return positions;
}

double hat(const glm::dvec3& offset) {
  const glm::dvec3 hats = glm::max(1.0 - glm::abs(offset), 0.0);
  return hats.x * hats.y * hats.z;
}

// The mean of falloff / r^2 over the cells around a node, in spherical coordinates around the
// light, by midpoints.
double mean_at(const PointSource& source, const glm::dvec3& node) {
  constexpr int polar_steps = 60;
  constexpr int azimuth_steps = 90;
  constexpr double step = 0.1;  // in spacings
  const LightFalloff& falloff = source.falloff;
  double sum = 0.0;
  for (int i = 0; i < polar_steps; ++i) {
    const double z = 2.0 * (i + 0.5) / polar_steps - 1.0;
    for (int k = 0; k < azimuth_steps; ++k) {
      const double azimuth = 2.0 * pi * (k + 0.5) / azimuth_steps;
      const double radius = std::sqrt(1.0 - z * z);
      const glm::dvec3 w(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
      const double intensity = falloff.at(w);
      if (!(intensity > 0.0)) continue;
      for (double r = 0.5 * step; r < 3.5; r += step) {
        sum += intensity * hat((source.position - node) / spacing + r * w);
      }
    }
  }
  return sum * step * 4.0 * pi / (polar_steps * azimuth_steps) / (spacing * spacing);
}

TEST(IncidentPointLight, ChangesContinuouslyWithTheLightsPosition) {
  constexpr double step = 1e-7;
  for (const auto& [name, falloff] : falloffs) {
    for (const glm::dvec3& position : positions_beside_nodes(100)) {
      const NodeLight here = incident_light(source_at(position, falloff), glm::ivec3(9));
      const NodeLight next = incident_light(
          source_at(position + step * glm::dvec3(0.7, 0.5, -0.6), falloff), glm::ivec3(9));
      const float max = *std::ranges::max_element(here.values);
      for (std::size_t i = 0; i < here.values.size(); ++i) {
        // Rounding of sums in single precision is larger than what a step changes.
        ASSERT_NEAR(here.values[i], next.values[i], 2e-5f * max)
            << name << " at " << position.x << ", " << position.y << ", " << position.z;
      }
    }
  }
}

// 5,400 directions of the converged mean leave 0.5%.
TEST(IncidentPointLight, IsTheMeanOverTheCellsAroundNodes) {
  const GridNodes nodes{glm::ivec3(9), static_cast<float>(spacing)};
  for (const auto& [name, falloff] : falloffs) {
    if (name == "narrow spot") continue;  // too few of those directions are in its cone
    for (const glm::dvec3& position : positions_beside_nodes(50)) {
      const PointSource source = source_at(position, falloff);
      const NodeLight incident = incident_light(source, glm::ivec3(9));
      for (const glm::ivec3 offset : {glm::ivec3(0), {1, 0, 0}, {0, 1, 1}}) {
        const glm::ivec3 node = glm::ivec3(position / spacing) + offset;
        const double expected = mean_at(source, spacing * glm::dvec3(node));
        const double nearest = 8.0 / (spacing * spacing);  // about that of a light at its node
        EXPECT_NEAR(arriving(incident, node_index(nodes, node)), expected, 0.01 * nearest)
            << name << " at " << position.x << ", " << position.y << ", " << position.z;
      }
    }
  }
}

// The means add up to the integral over their cells: the beam's solid angle times its length, of
// which the last node's cells hold half a spacing beyond the grid.
TEST(IncidentPointLight, BeamsBetweenNodesKeepTheirPower) {
  for (const double outer : {0.02, 0.5, 2.0, 8.0}) {
    const LightFalloff beam(light::Spot{{0.0, 0.0, 1.0}, outer, outer});
    for (const glm::dvec2 place : {glm::dvec2(4.0, 4.0), {4.5, 4.5}, {4.25, 4.1}}) {
      const PointSource source = source_at(spacing * glm::dvec3(place, 0.0), beam);
      const NodeLight incident = incident_light(source, {9, 9, 13});
      double sum = 0.0;
      for (std::size_t node = 0; node < incident.stride; ++node) sum += arriving(incident, node);
      const double length = 12.5 * spacing;
      const double solid_angle = 2.0 * pi * beam.dark_versine();
      EXPECT_NEAR(sum * spacing * spacing * spacing, solid_angle * length,
                  0.02 * solid_angle * length)
          << outer << " at " << place.x << ", " << place.y;
    }
  }
}

// The mean around points of a ceiling is of the ceiling's light, not of what is below the spot.
TEST(IncidentPointLight, ASpotBelowACeilingDoesNotLightIt) {
  const std::vector<Surface> ceiling{wall(0.0, 3.0)};
  const RayCaster ray_caster(ceiling);
  const GridNodes nodes{{7, 7, 5}, static_cast<float>(spacing)};
  const glm::dvec3 first(-3.1 * spacing, -3.2 * spacing, -0.6 * spacing);
  const GridOcclusion occlusion(ray_caster, ceiling, {}, first, nodes, {});
  NodePointLight light{
      source_at({0.0, 0.0, 0.4 * spacing}, LightFalloff(light::Spot{{0.0, 0.0, 1.0}, 30.0, 70.0}))};
  light.surfaces = &ray_caster;
  light.intensity = {1.0f};
  std::vector<float> reflected(occlusion.surfels().size(), 0.0f);
  ASSERT_FALSE(reflected.empty());
  add_reflected_point_light(light, occlusion, first, nodes, reflected, 1, {});
  EXPECT_EQ(std::ranges::count(reflected, 0.0f), std::ssize(reflected));
}

// The solid angle of a rectangle, from its middle plane's coordinates of two corners at height h.
double solid_angle(const glm::dvec2& low, const glm::dvec2& high, double h) {
  const auto up_to = [h](double x, double y) {
    return std::atan(x * y / (h * std::sqrt(x * x + y * y + h * h)));
  };
  return up_to(high.x, high.y) - up_to(low.x, high.y) - up_to(high.x, low.y) + up_to(low.x, low.y);
}

// All that falls on a wall is reflected, however near the light is. Surfels had its irradiance at
// their middles, but no more than that of a light half a spacing away: a third too little or too
// much.
TEST(IncidentPointLight, WallsReflectAllThatFallsOnThem) {
  const std::vector<Surface> walls{wall(0.0, 3.0)};
  const RayCaster ray_caster(walls);
  const GridNodes nodes{{7, 7, 5}, static_cast<float>(spacing)};
  const glm::dvec3 first(-3.1 * spacing, -3.2 * spacing, -0.6 * spacing);
  const GridOcclusion occlusion(ray_caster, walls, {}, first, nodes, {});
  for (const double height : {0.01, 0.1, 0.4, 1.0, 3.0}) {
    NodePointLight light{source_at({0.05, -0.03, height * spacing})};
    light.surfaces = &ray_caster;
    light.intensity = {1.0f};
    std::vector<float> reflected(occlusion.surfels().size(), 0.0f);
    add_reflected_point_light(light, occlusion, first, nodes, reflected, 1, {});
    double flux = 0.0;
    for (std::size_t i = 0; i < reflected.size(); ++i) {
      const GridOcclusion::Surfel& surfel = occlusion.surfels()[i];
      const bool is_straight = glm::length(glm::vec2(surfel.offset)) < 1e-4f;
      if (!is_straight) continue;
      flux += pi * static_cast<double>(reflected[i] / surfel.scattered.x) * spacing * spacing;
    }
    const glm::dvec2 low = glm::dvec2(first) - 0.5 * spacing - glm::dvec2(light.source.position);
    const double expected = solid_angle(low, low + 7.0 * spacing, light.source.position.z);
    EXPECT_NEAR(flux, expected, 0.01 * expected) << height;
  }
}

// With this grid's spacing a quarter of it lies at 0.225 along each axis.
TEST(IncidentPointLight, LightsOnLatticesOfTheGridMatchPaths) {
  Scene scene;
  scene.film = {8, 6};
  scene.camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.medium.append({{0, 0, 0}, 1.0, 1.5});
  scene.lights = {{glm::dvec3(0.225), glm::dvec3(10.0), {}}};
  expect_all_orders_match_paths(scene, "on a quarter of the spacing", {});
}

}  // namespace
}  // namespace brume
