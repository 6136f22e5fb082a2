#include "render/prepare/fog_extent.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/limits.h"
#include "core/math/infinity.h"
#include "core/scene/mesh_arrays.h"

namespace brume {

FogExtent::FogExtent(const Scene& scene) {
  const double b0 = scene.medium.homogeneous_density();
  const bool is_lit_from_afar =
      scene.environment || std::ranges::any_of(scene.lights, [](const Light& light) {
        return light.on && light.directional.has_value();
      });
  if (!is_lit_from_afar || !(b0 > 0.0)) return;
  glm::dvec3 low(infinity);
  glm::dvec3 high(-infinity);
  const auto add = [&](const glm::dvec3& p, double radius) {
    low = glm::min(low, p - radius);
    high = glm::max(high, p + radius);
  };
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    const Gaussian g = scene.medium.gaussian(i);
    add(g.center, 3.0 * g.radius);
  }
  for (const Surface& surface : scene.surfaces) {
    for (const glm::dvec3& p : world_points(surface)) add(p, 0.0);
  }
  const double diameter = glm::length(high - low);
  if (low.x <= high.x && diameter > 0.0) {
    ball_ = {0.5 * (low + high), diameter};
  } else {
    ball_.radius = 1.0 / b0;
  }
}

Box fog_bounds(double b0, std::span<const Light> lights) {
  const glm::dvec3 reach(std::min(2.0 / b0, limits::max_length));
  Box box{glm::dvec3(infinity), glm::dvec3(-infinity)};
  for (const Light& light : lights) {
    if (light.directional) continue;
    box.low = glm::min(box.low, light.position - reach);
    box.high = glm::max(box.high, light.position + reach);
  }
  if (!(box.low.x <= box.high.x)) return {-reach, reach};
  const glm::dvec3 extent = box.high - box.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const double step = std::exp2(std::floor(std::log2(longest)) - 3.0);
  return {step * glm::floor(box.low / step), step * glm::ceil(box.high / step)};
}

double FogExtent::ray_distance(const glm::dvec3& eye) const {
  return ball_.radius + glm::length(eye - ball_.center);
}

}  // namespace brume
