#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace brume {

// The unit vector at an angle theta from +z, and phi about it.
inline glm::dvec3 from_angles(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace brume
