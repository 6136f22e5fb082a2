#pragma once

#include "brume/scene.h"
#include "core/math/spherical_harmonics.h"

namespace brume {

// Radiance of a scene's environment, rotated and scaled. Its map must be loaded.

// Rotation from map to world space.
glm::dquat environment_rotation(const Environment& environment);

// Incident radiance from a unit direction, RGB [W/(sr u^2)].
glm::dvec3 environment_radiance(const Environment& environment, const glm::dvec3& direction);

// The same as spherical harmonics.
ShVector<glm::dvec3> environment_sh(const Environment& environment, int order);

}  // namespace brume
