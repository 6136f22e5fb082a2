#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/fit/fit_gaussian.h"

namespace brume {

// Initial Gaussians of a fit: repeatedly splits the group of voxels with the largest moment of
// inertia across its principal axis, until there are `count` groups (or single voxels); each group
// becomes a Gaussian of its mass, center and extent, an ellipsoid of its covariance. Nothing of use
// if stopped.
std::vector<FitGaussian> split_into_gaussians(const DensityGrid& grid, std::size_t count,
                                              FitShape shape, const std::stop_token& stop = {});

}  // namespace brume
