#include "render/prepare/fog_extent.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "brume/limits.h"
#include "core/math/infinity.h"
#include "core/math/sphere_rule.h"
#include "core/scene/lights/point_lights.h"

namespace brume {

FogExtent::FogExtent(const Scene& scene) {
  const double b0 = scene.medium.homogeneous_density();
  const bool is_lit_from_afar =
      scene.environment || std::ranges::any_of(scene.lights, [](const Light& light) {
        return light.on && light.as<light::Directional>();
      });
  if (!is_lit_from_afar || !(b0 > 0.0)) return;
  const auto bounds = lit_bounds(scene);
  const double diameter = bounds ? glm::length(bounds->high - bounds->low) : 0.0;
  if (diameter > 0.0) {
    ball_ = {0.5 * (bounds->low + bounds->high), diameter};
  } else {
    ball_.radius = 1.0 / b0;
  }
}

namespace {

// The box, its sides moved outwards to steps of an eighth of its length.
Box in_steps(const Box& box) {
  const glm::dvec3 extent = box.high - box.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const double step = std::exp2(std::floor(std::log2(longest)) - 3.0);
  return {step * glm::floor(box.low / step), step * glm::ceil(box.high / step)};
}

// Distance to the nearest surface, along the directions of the nodes of a sphere rule.
double clearance(const RayCaster& surfaces, const glm::dvec3& position) {
  double nearest = infinity;
  for (const SphereNode& node : sphere_rule(5)) {
    nearest = std::min(nearest, surfaces.first_hit(position, node.direction).distance);
  }
  return nearest;
}

}  // namespace

Box fog_bounds(double b0, std::span<const PointLight> lights) {
  const glm::dvec3 reach(std::min(2.0 / b0, limits::max_length));
  Box box{glm::dvec3(infinity), glm::dvec3(-infinity)};
  for (const PointLight& light : lights) {
    if (light.is_far) continue;
    box.low = glm::min(box.low, light.position - reach);
    box.high = glm::max(box.high, light.position + reach);
  }
  if (!(box.low.x <= box.high.x)) return {-reach, reach};
  return in_steps(box);
}

Box near_light_bounds(const RayCaster& surfaces, std::span<const PointLight> lights, double reach) {
  constexpr double clearances = 8.0;
  constexpr double worth = 0.5;  // of the sides of all
  // All levels of a grid reach some 400 times as far as the finest.
  constexpr double min_share = 1.0 / 128.0;
  const auto longest = [](const Box& box) {
    const glm::dvec3 extent = box.high - box.low;
    return std::max({extent.x, extent.y, extent.z});
  };
  const Box& all = surfaces.bounds();
  const double least = 0.5 * min_share * std::max(longest(all), 2.0 * reach);
  Box box{glm::dvec3(infinity), glm::dvec3(-infinity)};
  for (const PointLight& light : lights) {
    if (light.is_far) continue;
    const glm::dvec3 around(std::max(clearances * clearance(surfaces, light.position), least));
    box.low = glm::min(box.low, light.position - around);
    box.high = glm::max(box.high, light.position + around);
  }
  if (!(box.low.x <= box.high.x) || !(longest(box) <= worth * longest(all))) return all;
  return in_steps(box);
}

double FogExtent::ray_distance(const glm::dvec3& eye) const {
  return ball_.radius + glm::length(eye - ball_.center);
}

double FogExtent::ray_distance(const CameraRays& rays) const {
  return ball_.radius + std::abs(rays.distance_to(ball_.center));
}

}  // namespace brume
