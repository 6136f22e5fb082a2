#pragma once

#include <cstddef>
#include <vector>

#include "core/fit/fit_problem.h"

namespace brume {

// Gaussians to begin a fit with: the voxels are split, the group with the greatest moment of
// inertia first and across its longest axis, until there are `count` groups (or no two voxels are
// left in one); each group becomes the Gaussian of its mass, centre and extent.
std::vector<FitGaussian> split_into_gaussians(const DensityGrid& grid, std::size_t count);

}  // namespace brume
