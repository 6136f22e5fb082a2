#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace brume {

// Fractal value noise in [-1, 1]: `octaves` layers, each twice as fine and half as strong; the
// coarsest has one lattice cell per unit. Without functions of libm, so the same everywhere.
double fractal_noise(std::uint64_t seed, const glm::dvec3& point, int octaves);

}  // namespace brume
