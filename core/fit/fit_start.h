#pragma once

#include <cstddef>
#include <vector>

#include "core/fit/fit_problem.h"

namespace brume {

// Initial Gaussians of a fit: repeatedly splits the group of voxels with the largest moment of
// inertia across its principal axis, until there are `count` groups (or single voxels); each group
// becomes a Gaussian of its mass, center and extent.
std::vector<FitGaussian> split_into_gaussians(const DensityGrid& grid, std::size_t count);

}  // namespace brume
