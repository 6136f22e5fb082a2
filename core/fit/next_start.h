#pragma once

#include <span>
#include <vector>

#include "core/medium/gaussian.h"
#include "core/volume/density_grid.h"
#include "core/volume/velocity_grid.h"

namespace brume {

// Gaussians to begin the fit of a sequence's next frame with: those of the frame before, moved with
// its velocity for the time between both [s]. Solvers store velocities in units of their own and
// seldom say which, so parts of that time are tried too, down to 1/32 and 0: the one whose result
// is nearest to the next frame is taken. Gaussian i stays Gaussian i.
std::vector<Gaussian> next_start(const DensityGrid& next, std::span<const Gaussian> gaussians,
                                 const VelocityGrid& velocity, double seconds);

}  // namespace brume
