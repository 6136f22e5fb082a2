#pragma once

#include <vector>

#include "core/scene/atmosphere/air.h"
#include "core/scene/atmosphere/radiance_moments.h"

namespace brume {

// All light in the atmosphere that was scattered or reflected by the ground, around a zenith angle
// of the sun, for an irradiance of 1 of the sun outside at all wavelengths. Orders of scattering
// are computed one after the other, in shells, with the moments of the light before (degree 2,
// which is exact for molecules; of aerosol's phase function higher ones only count in light
// scattered once); what follows the last computed order is a geometric series, as in Hillaire
// (2020), of each place and wavelength by itself.
struct ScatteredLight {
  RadianceMoments radiance;
  // Irradiance of the ground by scattered light, for each of the zenith angles of `radiance`.
  std::vector<Spectrum> ground;

  ScatteredLight(const Air& air, const Spectrum& ground_reflectance, double sun_zenith);

  // The radiance of the ground, which reflects alike in all directions.
  [[nodiscard]] Spectrum ground_radiance(const Air& air, const Spectrum& reflectance,
                                         double sun_zenith) const;
};

}  // namespace brume
