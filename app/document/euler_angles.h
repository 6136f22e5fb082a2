#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace brume {

// Rotations as a designer enters them [degrees]: about the world's x axis, then y, then z.
glm::dquat from_euler_angles(const glm::dvec3& degrees);  // unit
// To a billionth. y in [-90, 90], x and z in [-180, 180]; z = 0 at y = +-90, where x does the same.
glm::dvec3 to_euler_angles(const glm::dquat& rotation);

}  // namespace brume
