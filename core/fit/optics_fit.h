#pragma once

#include <optional>
#include <span>

#include "brume/density_grid.h"
#include "brume/gaussian.h"

namespace brume {

// The targets, on the voxels of a density grid, of the optics of Gaussians that are fitted to it.
struct OpticsTargets {
  std::optional<ColorGrid> extinction;  // density / albedo [1/u]; absent: the density
  std::optional<ColorGrid> emission;    // extinction * emission [W/(sr u^3)]
};

// Relative RMS errors over voxels and adjacent empty blocks, of all channels; where there are
// targets. That of the density is part of them.
struct OpticsErrors {
  std::optional<double> extinction;
  std::optional<double> emission;
};

// Sets the optics of Gaussians that were fitted to `density`, by least squares: of their
// extinctions, which set their albedos (from min_fitted_albedo to 1), and of what they emit per
// length. Where albedo or emission are the same everywhere, each Gaussian gets just that. In
// parallel, deterministic.
OpticsErrors fit_optics(const DensityGrid& density, const OpticsTargets& targets,
                        std::span<Gaussian> gaussians);

// A channel of a colour that is 0 would be matter of infinite extinction.
inline constexpr double min_fitted_albedo = 0.01;

}  // namespace brume
