#pragma once

#include "core/fit/optics_fit.h"
#include "core/io/volume/volume_optics.h"

namespace brume {

// How the colours, temperatures and flames of a volume become optics.
struct AppearanceOptions {
  VolumeOpticsNames grids;
  double temperature_scale = 1.0;     // of a temperature of 1 in the file [K]
  double emission_scale = 1.0;        // factor of all emission
  double flame_scale = 0.1;           // extinction of a flame of 1 [1/u]
  double flame_temperature = 1850.0;  // where there is no temperature at which matter glows [K]
};

// The optics of smoke, whose densities were multiplied by `density_scale`: the colour is its
// albedo, 1 where it has none; it shines as its emission says, and as a black body of its
// temperature.
OpticsTargets smoke_targets(const DensityGrid& density, double density_scale,
                            const VolumeOptics& optics, const AppearanceOptions& options);

// The optics of flames, whose extinctions are given: they shine as black bodies.
OpticsTargets flame_targets(const DensityGrid& extinction, const VolumeOptics& optics,
                            const AppearanceOptions& options);

// Flames hardly scatter.
inline constexpr double flame_albedo = 0.02;

}  // namespace brume
