#include "app/document/euler_angles.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

namespace brume {

glm::dquat from_euler_angles(const glm::dvec3& degrees) {
  const glm::dvec3 angles = glm::radians(degrees);
  const glm::dquat x = glm::angleAxis(angles.x, glm::dvec3(1.0, 0.0, 0.0));
  const glm::dquat y = glm::angleAxis(angles.y, glm::dvec3(0.0, 1.0, 0.0));
  const glm::dquat z = glm::angleAxis(angles.z, glm::dvec3(0.0, 0.0, 1.0));
  return glm::normalize(z * y * x);
}

glm::dvec3 to_euler_angles(const glm::dquat& rotation) {
  const glm::dmat3 m = glm::mat3_cast(rotation);
  const double cos_y = std::hypot(m[0][0], m[0][1]);
  glm::dvec3 angles{0.0, std::atan2(-m[0][2], cos_y), 0.0};
  if (cos_y > 1e-7) {
    angles.x = std::atan2(m[1][2], m[2][2]);
    angles.z = std::atan2(m[0][1], m[0][0]);
  } else {  // the former would be noise
    angles.x = std::atan2(-m[2][1], m[1][1]);
  }
  constexpr double digits = 1e9;
  return glm::round(glm::degrees(angles) * digits) / digits + 0.0;  // no -0
}

glm::dvec3 EnteredAngles::of(GaussianId id, const Gaussian& gaussian) const {
  if (gaussian.is_ball()) return glm::dvec3(0.0);
  const glm::dquat& rotation = gaussian.shape.rotation;
  const auto found = entered_.find(id);
  const bool is_as_entered =
      found != entered_.end() && from_euler_angles(found->second) == rotation;
  return is_as_entered ? found->second : to_euler_angles(rotation);
}

void EnteredAngles::enter(GaussianId id, const glm::dvec3& degrees, Gaussian& gaussian) {
  entered_[id] = degrees;
  gaussian.shape.rotation = from_euler_angles(degrees);
}

}  // namespace brume
