#pragma once

#include <glm/vec3.hpp>

namespace brume {

// The color of a splat that is the same from every side, as RGB coefficients of the spherical
// harmonic of degree 0: color = 0.5 + 0.2821 coefficient, sRGB-encoded as viewers of splats expect.
// `albedo` in [0, 1].
glm::dvec3 sh_of_albedo(const glm::dvec3& albedo);

// The inverse for finite coefficients; what is darker or brighter becomes the least or greatest
// albedo, domain::albedo. `is_linear`: the color is not encoded.
glm::dvec3 albedo_of_sh(const glm::dvec3& coefficient, bool is_linear = false);

}  // namespace brume
