#pragma once

#include <algorithm>
#include <glm/vec3.hpp>

namespace brume {

[[nodiscard]] inline double max_component(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

[[nodiscard]] inline double min_component(const glm::dvec3& v) {
  return std::min({v.x, v.y, v.z});
}

}  // namespace brume
