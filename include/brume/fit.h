#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "brume/density_grid.h"
#include "brume/export.h"
#include "brume/gaussian.h"

namespace brume {

// The shape of fitted Gaussians. Where volumes have strands and sheets, half as many ellipsoids
// make the error of balls.
enum class FitShape { ball, ellipsoid };

struct FitOptions {
  std::size_t count = 500;  // of Gaussians, at most
  // Target relative RMS error of density: stops when it is reached, and uses fewer Gaussians than
  // `count` if they suffice. 0: optimize fully with `count` Gaussians.
  double max_error = 0.0;
  FitShape shape = FitShape::ellipsoid;
};

struct Fit {
  std::vector<Gaussian> gaussians;  // in the world
  double density_error = 0.0;       // relative RMS over voxels and adjacent empty blocks
  // Number of Jacobian products at the grid's resolution, a measure of time.
  std::size_t products = 0;
};

// Fits Gaussians to the density of a grid by least squares: split_into_gaussians(), then
// Levenberg-Marquardt (normal equations by conjugate gradients); the least useful Gaussians are
// moved to where the residual is largest. Where each Gaussian has thousands of voxels, this is done
// at a lower resolution, and ends with a few steps at that of the grid. Finally densities are
// scaled to the grid's mass. An empty grid gives none. `progress` gets values in [0, 1]. nullopt if
// stopped. Deterministic for any number of threads.
BRUME_EXPORT std::optional<Fit> fit_gaussians(const DensityGrid& grid, const FitOptions& options,
                                              const std::stop_token& stop = {},
                                              const std::function<void(double)>& progress = {});

// Fits from given Gaussians, such as the previous frame's: result i continues start[i] unless it
// was moved elsewhere (renewed[i]). Same number of Gaussians; ellipsoids if one of them is one.
struct Refit {
  Fit fit;
  std::vector<bool> renewed;
};
BRUME_EXPORT std::optional<Refit> refit_gaussians(const DensityGrid& grid,
                                                  std::span<const Gaussian> start,
                                                  const std::stop_token& stop = {},
                                                  const std::function<void(double)>& progress = {});

}  // namespace brume
