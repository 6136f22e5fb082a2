#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/medium/gaussian.h"
#include "core/volume/density_grid.h"

namespace brume {

struct FitOptions {
  std::size_t count = 500;  // of Gaussians, at most
  // Once the relative RMS error of density is not above this, no more work is done; fewer
  // Gaussians than `count` are taken where they will do. 0: all the work, `count` Gaussians.
  double max_error = 0.0;
};

struct Fit {
  std::vector<Gaussian> gaussians;  // in the world
  double density_error = 0.0;       // relative RMS over the voxels and what lies around them
  std::size_t products = 0;         // with the derivatives of all: what the time went into
};

// Gaussians that make the density of a grid, in the sense of least squares over its voxels: by
// split_into_gaussians(), then Levenberg-Marquardt steps (the normal equations by conjugate
// gradients), after which Gaussians that do little begin anew where most is missing. In the end all
// densities are scaled so that the mass is the grid's. An empty grid gives no Gaussians.
// `progress` receives values in [0, 1]. Nothing is returned when it was stopped. Same input, same
// result, whatever the number of threads.
std::optional<Fit> fit_gaussians(const DensityGrid& grid, const FitOptions& options,
                                 const std::stop_token& stop = {},
                                 const std::function<void(double)>& progress = {});

// The same from Gaussians that almost fit, as those of a former frame of a sequence do: result i is
// what became of start[i], unless it was of no more use and took its place anew where something is
// missing (renewed[i]). As many as there were.
struct Refit {
  Fit fit;
  std::vector<bool> renewed;
};
std::optional<Refit> refit_gaussians(const DensityGrid& grid, std::span<const Gaussian> start,
                                     const std::stop_token& stop = {},
                                     const std::function<void(double)>& progress = {});

}  // namespace brume
