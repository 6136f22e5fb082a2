#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/transport/spot_falloff.h"
#include "render/geometry/fog_ball.h"

namespace brume {

// A light as methods evaluate it: a point, for a directional light far away
// (core/scene/far_lights).
struct PointSource {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};  // RGB [W/sr]
  double h_min = 0.0;         // see light_limits.h [u]
  SpotFalloff spot{};
  FogBall fog{};  // that its light passes, of a far light; else endless: all the way
  bool is_far = false;

  // Length of homogeneous fog from it to x [u].
  [[nodiscard]] double fog_length(const glm::dvec3& x) const {
    const glm::dvec3 q = position - x;
    const double r = glm::length(q);
    return r > 0.0 ? std::min(r, fog.length(x, q / r)) : 0.0;
  }
};

}  // namespace brume
