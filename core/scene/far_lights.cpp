#include "core/scene/far_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <optional>

#include "core/math/basis.h"
#include "core/math/infinity.h"
#include "core/math/unit_direction.h"
#include "core/scene/mesh_arrays.h"

namespace brume {
namespace {

// For a share of the light's irradiance, in the unit direction.
Light far_light(const Light& light, double share, const glm::dvec3& direction,
                const LitRegion& region) {
  const double distance = far_light_distance * region.diameter;
  Light far = light;
  far.position = region.center + distance * direction;
  // Single precision ends.
  far.intensity = glm::min(share * distance * distance * light.intensity, glm::dvec3(1e35));
  return far;
}

// Directions of equal irradiance on what faces the disc: evenly over the disc of their sines
// (Vogel's spiral).
void add_disc(const Light& light, int count, const LitRegion& region, std::vector<Light>& lights) {
  const glm::dvec3 axis = to_light(*light.directional);
  const auto [u, v] = make_basis(axis);
  const double edge = std::sin(glm::radians(0.5 * light.directional->angular_diameter));
  constexpr double golden_angle = std::numbers::pi * (3.0 - 2.2360679774997896964);
  for (int k = 0; k < count; ++k) {
    const double sine = edge * std::sqrt((k + 0.5) / count);
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double turn = golden_angle * k;
    const glm::dvec3 direction = cosine * axis + sine * (std::cos(turn) * u + std::sin(turn) * v);
    lights.push_back(far_light(light, 1.0 / (count * cosine), direction, region));
  }
}

}  // namespace

std::optional<LitBounds> lit_bounds(const Scene& scene) {
  LitBounds bounds{glm::dvec3(infinity), glm::dvec3(-infinity)};
  const auto add = [&](const glm::dvec3& p, double radius) {
    bounds.low = glm::min(bounds.low, p - radius);
    bounds.high = glm::max(bounds.high, p + radius);
  };
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    const Gaussian g = scene.medium.gaussian(i);
    add(g.center, 3.0 * g.radius);
  }
  for (const Surface& surface : scene.surfaces) {
    for (const glm::dvec3& p : world_points(surface)) add(p, 0.0);
  }
  return bounds.low.x <= bounds.high.x ? std::optional(bounds) : std::nullopt;
}

LitRegion LitRegion::of(const Scene& scene) {
  const double b0 = scene.medium.homogeneous_density();
  LitRegion region;
  double length = b0 > 0.0 ? 2.0 / b0 : region.diameter;
  if (const auto bounds = lit_bounds(scene)) {
    region.center = 0.5 * (bounds->low + bounds->high);
    const double diagonal = glm::length(bounds->high - bounds->low);
    if (diagonal > 0.0) length = diagonal;
  }
  region.diameter = std::exp2(std::ceil(std::log2(length)));
  const double step = region.diameter / 16.0;
  region.center = step * glm::round(region.center / step);
  return region;
}

glm::dvec3 to_light(const Directional& light) {
  return -unit_direction(light.direction, {0.0, -1.0, 0.0});
}

Light as_point_light(const Light& light, const LitRegion& region) {
  return light.directional ? far_light(light, 1.0, to_light(*light.directional), region) : light;
}

std::vector<Light> as_point_lights(const Scene& scene, int disc_points) {
  std::vector<Light> lights;
  std::optional<LitRegion> region;  // reads all vertices: not for scenes without directional lights
  for (const Light& light : scene.lights) {
    if (!light.on || light.intensity == glm::dvec3(0.0)) continue;
    if (!light.directional) {
      lights.push_back(light);
      continue;
    }
    if (!region) region = LitRegion::of(scene);
    if (light.directional->angular_diameter > 0.0 && disc_points > 1) {
      add_disc(light, disc_points, *region, lights);
    } else {
      lights.push_back(as_point_light(light, *region));
    }
  }
  return lights;
}

}  // namespace brume
