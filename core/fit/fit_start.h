#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "brume/density_grid.h"
#include "brume/fit.h"
#include "brume/gaussian.h"
#include "core/fit/fit_gaussian.h"
#include "core/volume/velocity_grid.h"

namespace brume {

// Initial Gaussians of a fit: repeatedly splits the group of voxels with the largest moment of
// inertia across its principal axis, until there are `count` groups (or single voxels); each group
// becomes a Gaussian of its mass, center and extent, an ellipsoid of its covariance. Nothing of use
// if stopped.
std::vector<FitGaussian> split_into_gaussians(const DensityGrid& grid, std::size_t count,
                                              FitShape shape, const std::stop_token& stop = {});

// A fit for a first look: the initial Gaussians, improved by a few steps. nullopt if stopped.
std::optional<Fit> fit_preview(const DensityGrid& grid, const FitOptions& options,
                               const std::stop_token& stop = {});

// Initial Gaussians of a sequence's next frame: the previous ones advected by its velocity over the
// time between them [s]. Since solvers use undocumented velocity units, fractions of that time down
// to 1/32 and 0 are tried, and the best match to the next frame is used. Preserves the order.
std::vector<Gaussian> next_start(const DensityGrid& next, std::span<const Gaussian> gaussians,
                                 const VelocityGrid& velocity, double seconds);

}  // namespace brume
