#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "brume/surface.h"

namespace brume {

// The part of light that a material reflects, RGB in [0, 1], of light that comes evenly from all
// directions: its directional albedo, averaged over a cosine. Highlights of every width are
// integrated over half vectors; textures count by their averages. `color`: of
// vertices, see MeshArrays.
glm::dvec3 mean_reflectance(const Material& material, const glm::dvec4& color = glm::dvec4(1.0));

}  // namespace brume
