#pragma once

#include "core/scene/atmosphere/air.h"
#include "core/scene/atmosphere/radiance_moments.h"

namespace brume {

// Light along a ray through the atmosphere, for an irradiance of 1 of the sun outside it at all
// wavelengths.

struct SkyRay {
  double altitude;         // where it starts [km]
  double sun_zenith;       // there [radians]
  SkyDirection direction;  // the way it goes

  // The cosine of its angle to the sun.
  [[nodiscard]] double cos_sun() const;
  [[nodiscard]] bool hits_ground() const;
  // Its end at the ground or at the top of the atmosphere [km].
  [[nodiscard]] double length() const;
  [[nodiscard]] SkyRay moved(double distance) const;
};

// Radiance at the start of a ray, without what comes from the ground [1/sr]; that of sunlight
// scattered once lacks the factor of the phase function [1].
struct PathLight {
  Spectrum once_by_molecules{};
  Spectrum once_by_aerosol{};
  Spectrum again{};          // light of `incident` scattered once more
  Spectrum transmittance{};  // of the whole ray

  [[nodiscard]] double once(std::size_t k, double cos_sun) const {
    return molecule_phase(cos_sun) * once_by_molecules[k] +
           aerosol_phase(cos_sun) * once_by_aerosol[k];
  }
};
// `incident` null: none. The sun's light counts if `of_sun`.
PathLight light_along(const Air& air, const SkyRay& ray, int steps, bool of_sun,
                      const RadianceMoments* incident);

// The sun's irradiance on a surface that faces it, at an altitude [km].
Spectrum sun_irradiance(const Air& air, double altitude, double sun_zenith);

}  // namespace brume
