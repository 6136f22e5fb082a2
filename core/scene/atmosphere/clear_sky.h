#pragma once

#include <glm/vec3.hpp>

#include "core/scene/atmosphere/path_light.h"
#include "core/scene/atmosphere/scattered_light.h"

namespace brume {

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
