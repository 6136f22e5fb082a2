#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <unordered_map>

#include "brume/gaussian.h"

namespace brume {

// Rotations as a designer enters them [degrees]: about the world's x axis, then y, then z.
glm::dquat from_euler_angles(const glm::dvec3& degrees);  // unit
// To a billionth. y in [-90, 90], x and z in [-180, 180]; z = 0 at y = +-90, where x does the same.
glm::dvec3 to_euler_angles(const glm::dquat& rotation);

// The angles of ellipsoids as they were entered, while they give the rotation: others give it, too.
class EnteredAngles {
 public:
  [[nodiscard]] glm::dvec3 of(GaussianId id, const Gaussian& gaussian) const;  // of a ball 0
  // Sets the Gaussian's rotation.
  void enter(GaussianId id, const glm::dvec3& degrees, Gaussian& gaussian);
  void forget() { entered_.clear(); }

 private:
  std::unordered_map<GaussianId, glm::dvec3> entered_;
};

}  // namespace brume
