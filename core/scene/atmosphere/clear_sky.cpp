#include "core/scene/atmosphere/clear_sky.h"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

namespace brume {
namespace {

// A moonless night sky, some 22 magnitudes per square arcsecond: 1.7e-4 cd/m^2.
const glm::dvec3 night(1.7e-4 / 683.0);

constexpr int view_steps = 48;

}  // namespace

ClearSky::ClearSky(double elevation, double turbidity, const glm::dvec3& ground_albedo)
    : sun_zenith_(glm::radians(90.0 - elevation)),
      albedo_(ground_albedo),
      air_(turbidity),
      reflectance_(reflectance_spectrum(ground_albedo)),
      scattered_(air_, reflectance_, sun_zenith_) {}

glm::dvec3 ClearSky::sun_irradiance() const {
  return glm::max(rec709_of_sunlight(brume::sun_irradiance(air_, 0.0, sun_zenith_)), 0.0);
}

ClearSky::Parts ClearSky::parts(const SkyDirection& direction) const {
  const PathLight light =
      light_along(air_, {0.0, sun_zenith_, direction}, view_steps, true, &scattered_.radiance);
  return {rec709_of_sunlight(light.once_by_molecules), rec709_of_sunlight(light.once_by_aerosol),
          rec709_of_sunlight(light.again)};
}

glm::dvec3 ClearSky::radiance_of(const Parts& parts, double cos_sun) const {
  return night + glm::max(molecule_phase(cos_sun) * parts.once_by_molecules +
                              aerosol_phase(cos_sun) * parts.once_by_aerosol + parts.again,
                          0.0);
}

glm::dvec3 ClearSky::ground_radiance() const {
  const Spectrum light = scattered_.ground_radiance(air_, reflectance_, sun_zenith_);
  return glm::max(rec709_of_sunlight(light), 0.0) + albedo_ * night;
}

glm::dvec3 ClearSky::radiance(const glm::dvec3& direction) const {
  if (direction.y < 0.0) return ground_radiance();
  const SkyDirection seen{direction.y, -direction.z};
  const SkyRay ray{0.0, sun_zenith_, seen};
  return radiance_of(parts(seen), ray.cos_sun());
}

}  // namespace brume
