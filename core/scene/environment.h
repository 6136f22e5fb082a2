#pragma once

#include "core/math/spherical_harmonics.h"
#include "core/scene/scene.h"

namespace brume {

// The light of a scene's environment, turned and scaled as the scene says. Its map must be loaded.

// What turns directions of the map into those of the scene.
glm::dquat environment_rotation(const Environment& environment);

// Radiance that arrives from a unit direction, RGB [W/(sr u^2)].
glm::dvec3 environment_radiance(const Environment& environment, const glm::dvec3& direction);

// The same as spherical harmonics.
ShVector<glm::dvec3> environment_sh(const Environment& environment, int order);

}  // namespace brume
