#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/atmosphere/air.h"
#include "core/scene/atmosphere/path_light.h"
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

// A clear sky seen from the ground, in linear Rec. 709 and the RGB watts of lumens_per_watt: a
// noon sun of some 145 W/m^2 and a blue sky of some 5 W/(sr m^2). The sun's disc is not in it.
class ClearSky {
 public:
  // Elevation of the sun's center above the horizon, in [-90, 90] [degrees]; see Air.
  ClearSky(double elevation, double turbidity, const glm::dvec3& ground_albedo);

  // Irradiance of what faces the sun; black where it has set.
  [[nodiscard]] glm::dvec3 sun_irradiance() const;

  // Radiance in a direction with y up and the sun at azimuth -z: of the sky, or below the horizon
  // of the ground.
  [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;

  // The same above the horizon, in parts that vary slowly with the direction, unlike their phase
  // functions. `up` in [0, 1].
  struct Parts {
    glm::dvec3 once_by_molecules;
    glm::dvec3 once_by_aerosol;
    glm::dvec3 again;
  };
  [[nodiscard]] Parts parts(const SkyDirection& direction) const;
  [[nodiscard]] glm::dvec3 radiance_of(const Parts& parts, double cos_sun) const;
  [[nodiscard]] glm::dvec3 ground_radiance() const;

 private:
  double sun_zenith_;  // [radians]
  glm::dvec3 albedo_;
  Air air_;
  Spectrum reflectance_;
  ScatteredLight scattered_;
};

}  // namespace brume
