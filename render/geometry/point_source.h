#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/scene/lights/point_lights.h"
#include "render/geometry/fog_ball.h"

namespace brume {

// A light as methods evaluate it.
struct PointSource : PointLight {
  double h_min = 0.0;  // see light_limits.h [u]
  FogBall fog{};       // that its light passes; endless: all the way

  // Squared, for light at surfaces, which next to an area light are lit as by all of its radiance.
  [[nodiscard]] double distance2(const glm::dvec3& x) const {
    const glm::dvec3 q = x - position;
    return std::max(glm::dot(q, q), radius * radius);
  }

  // Length of homogeneous fog from it to x [u].
  [[nodiscard]] double fog_length(const glm::dvec3& x) const {
    const glm::dvec3 q = position - x;
    const double r = glm::length(q);
    return r > 0.0 ? fog.length(x, q / r, r) : 0.0;
  }
};

}  // namespace brume
