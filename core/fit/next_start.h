#pragma once

#include <span>
#include <vector>

#include "brume/density_grid.h"
#include "brume/gaussian.h"
#include "core/volume/velocity_grid.h"

namespace brume {

// Initial Gaussians of a sequence's next frame: the previous ones advected by its velocity over the
// time between them [s]. Since solvers use undocumented velocity units, fractions of that time down
// to 1/32 and 0 are tried, and the best match to the next frame is used. Preserves the order.
std::vector<Gaussian> next_start(const DensityGrid& next, std::span<const Gaussian> gaussians,
                                 const VelocityGrid& velocity, double seconds);

}  // namespace brume
