#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "render/simd/gaussian_kernels.h"

namespace brume {

// The work of the view pass: increments, the optical depth of one Gaussian on one slice of one ray;
// and pairs, what must be known once of a Gaussian and a ray before: where they come nearest, the
// depth of the whole line, erf at the first boundary.

// The kernels' arithmetic on registers in several independent chains, for the same instruction set:
// a lower bound of their time. Returns the number of evaluations, at least `count`.
std::uint64_t increments_in_registers(std::uint64_t count);
std::uint64_t pairs_in_registers(std::uint64_t count);

// Floats in a vector of that instruction set.
std::size_t vector_lanes();

// The work of these rays. Pairs: a Gaussian is above its cutoff somewhere on a ray before it ends.
// Increments: on the slices between the ends of that chord. `lanes` rays are taken together, as in
// a vector: what one of them needs all have.
struct ViewWork {
  std::uint64_t pairs = 0;
  std::uint64_t increments = 0;
};
ViewWork count_view_work(const GaussianBatch& gaussians, const PathBatch& rays,
                         std::span<const float> boundaries, std::size_t lanes);

}  // namespace brume
