#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "render/cpu/kernels.h"

namespace brume {

// The work of the view pass in increments: the optical depth of one Gaussian on one slice of one
// ray.

// The arithmetic of increments alone, for the same instruction set as the kernels': erf by the
// kernels' polynomial and what makes it a depth, on data in registers, several independent chains
// at once. The least time that increments can take. Returns how many it evaluated, at least
// `count`.
std::uint64_t increments_in_registers(std::uint64_t count);

// Floats in a vector of that instruction set.
std::size_t vector_lanes();

// How many increments these rays need: slices between the ends of the chord along which a Gaussian
// is above its cutoff, up to the end of the ray. `lanes` rays are taken together, as in a vector:
// where one of them needs an increment all have it.
std::uint64_t count_increments(const GaussianBatch& gaussians, const PathBatch& rays,
                               std::span<const float> boundaries, std::size_t lanes);

}  // namespace brume
