#include "core/scene/atmosphere/path_light.h"

#include <algorithm>
#include <cmath>

#include "core/scene/atmosphere/slant_columns.h"

namespace brume {
namespace {

// Light of all directions scattered into a ray per km.
void add_scattered(const Air& air, const AirAmounts& density, const Moments& incident,
                   const SkyDirection& direction, Spectrum& source) {
  static const PhaseMoments by_molecules = molecule_moments();
  static const PhaseMoments by_aerosol = aerosol_moments();
  const auto y = even_harmonics(direction);
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    const double mean = y[0] * incident[0][k];
    const double first = y[1] * incident[1][k] + y[2] * incident[2][k];
    const double second = y[3] * incident[3][k] + y[4] * incident[4][k] + y[5] * incident[5][k];
    source[k] = density.molecules * air.molecules[k] *
                    (mean + by_molecules.first * first + by_molecules.second * second) +
                density.aerosol * air.aerosol_scattering[k] *
                    (mean + by_aerosol.first * first + by_aerosol.second * second);
  }
}

}  // namespace

double SkyRay::cos_sun() const {
  return std::cos(sun_zenith) * direction.up + std::sin(sun_zenith) * direction.sunward;
}

bool SkyRay::hits_ground() const {
  return direction.up < cos_horizon(altitude);
}

double SkyRay::length() const {
  const double radius = ground_radius + altitude;
  const double middle = -radius * direction.up;
  const double passing_square = radius * radius * (1.0 - direction.up * direction.up);
  const auto half_chord = [&](double r) {
    return std::sqrt(std::max(r * r - passing_square, 0.0));
  };
  const double distance = hits_ground() ? middle - half_chord(ground_radius)
                                        : middle + half_chord(ground_radius + atmosphere_height);
  return std::max(distance, 0.0);
}

SkyRay SkyRay::moved(double distance) const {
  const double radius = ground_radius + altitude;
  const double moved_up = radius * direction.up + distance;
  const double moved_radius =
      std::sqrt(radius * radius + distance * (2.0 * radius * direction.up + distance));
  const double to_sun = cos_sun();
  const double cosine =
      std::clamp((radius * std::cos(sun_zenith) + distance * to_sun) / moved_radius, -1.0, 1.0);
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double up = std::clamp(moved_up / moved_radius, -1.0, 1.0);
  const double most = std::sqrt(1.0 - up * up);
  const double sunward = sine > 1e-9 ? std::clamp((to_sun - cosine * up) / sine, -most, most) : 0.0;
  return {moved_radius - ground_radius, std::acos(cosine), {up, sunward}};
}

PathLight light_along(const Air& air, const SkyRay& ray, int steps, bool of_sun,
                      const RadianceMoments* incident) {
  PathLight light;
  light.transmittance.fill(1.0);
  const double length = ray.length();
  const bool falls = ray.hits_ground();
  const bool rises = ray.direction.up >= 0.0;
  // Steps are short where the ray is low.
  const auto distance_of = [&](double share) {
    return length * (rises ? share * share : falls ? share * (2.0 - share) : share);
  };
  double start = 0.0;
  for (int step = 0; step < steps; ++step) {
    const double end = distance_of((step + 1.0) / steps);
    const double span = end - start;
    const SkyRay place = ray.moved(distance_of((step + 0.5) / steps));
    start = end;
    const AirAmounts density = air_density(place.altitude);
    const Spectrum sun =
        of_sun ? sun_irradiance(air, place.altitude, place.sun_zenith) : Spectrum{};
    Spectrum again{};
    if (incident) {
      add_scattered(air, density, incident->at(place.altitude, place.sun_zenith), place.direction,
                    again);
    }
    for (std::size_t k = 0; k < spectrum_size; ++k) {
      const double extinction = std::max(air.depth(density, k), 1e-12);
      const double passed = attenuation(extinction * span);
      const double weight = light.transmittance[k] * (1.0 - passed) / extinction;
      light.once_by_molecules[k] += weight * density.molecules * air.molecules[k] * sun[k];
      light.once_by_aerosol[k] += weight * density.aerosol * air.aerosol_scattering[k] * sun[k];
      light.again[k] += weight * again[k];
      light.transmittance[k] *= passed;
    }
  }
  return light;
}

Spectrum sun_irradiance(const Air& air, double altitude, double sun_zenith) {
  Spectrum light{};
  const double cosine = std::cos(sun_zenith);
  const double visible = visible_sun(altitude, cosine);
  if (!(visible > 0.0)) return light;
  const AirAmounts columns = slant_columns(altitude, cosine);
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    light[k] = visible * attenuation(air.depth(columns, k));
  }
  return light;
}

}  // namespace brume
