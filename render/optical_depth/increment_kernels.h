#pragma once

#include <cstddef>
#include <cstdint>

#include "render/optical_depth/ray_slices.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {

// Optical depth of Gaussians on the slices of rays (Highway, single precision).

// Half the optical depth of a line through a Gaussian above which coefficient::erf_fast is too
// coarse; below it errs by at most 3e-4 of optical depth.
constexpr float exact_above = 10.0f;

// increments[k * rays.padded_size() + i] += optical depth of the Gaussians on slice k of ray i;
// nothing before t_0 or after t_K. If they have optics, the same times their albedo and their
// emission R, G, B follows, each as long as the slices before the last boundary times the rays.
// Unless null, moments[k * rays.padded_size() + i] += the same times the mean distance at which the
// slice's part of a Gaussian lies [u]. Returns the Gaussian x ray pairs evaluated.
std::uint64_t accumulate_increments(const GaussianBatch& gaussians, const PathBatch& rays,
                                    const RaySlices& slices, float* increments,
                                    float* moments = nullptr);
constexpr std::size_t optics_increments = 5;  // with those of optical depth

}  // namespace brume
