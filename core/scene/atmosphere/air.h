#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <numbers>

namespace brume {

// A clear atmosphere in spherical shells: molecules, ozone and aerosol. Refraction is left out.

inline constexpr double ground_radius = 6360.0;                          // [km]
inline constexpr double atmosphere_height = 100.0;                       // [km]
inline constexpr double sun_diameter = 0.53 * std::numbers::pi / 180.0;  // [radians]

// The wavelengths that light is followed at: 380 nm, 410 nm, ...
inline constexpr std::size_t spectrum_size = 12;
using Spectrum = std::array<double, spectrum_size>;
double wavelength_of(std::size_t k);  // [nm]

// Amounts of each constituent, in columns from the ground straight up through all of it.
struct AirAmounts {
  double molecules = 0.0;
  double aerosol = 0.0;
  double ozone = 0.0;
};

// Amounts per km at an altitude [km]: scale heights of 8 km (molecules) and 1.2 km (aerosol); ozone
// between 10 and 40 km, most at 25 km (Bruneton 2017).
AirAmounts air_density(double altitude);

// Optical depths of such columns.
struct Air {
  Spectrum molecules{};           // scattering
  Spectrum aerosol_scattering{};  // the rest of its extinction is absorbed
  Spectrum aerosol_extinction{};
  Spectrum ozone{};  // absorption

  // Molecules at standard pressure (Hansen and Travis 1974), 300 Dobson units of ozone, and the
  // aerosol that makes the optical depth of both scatterers at 550 nm `turbidity` times that of
  // the molecules (Preetham 1999): none at 1. It falls like wavelength^-1.3 and scatters 92.5%
  // (OPAC's average continental aerosol, Hess, Koepke and Schult 1998).
  explicit Air(double turbidity);

  // Optical depth at a wavelength.
  [[nodiscard]] double depth(const AirAmounts& amounts, std::size_t k) const {
    return amounts.molecules * molecules[k] + amounts.aerosol * aerosol_extinction[k] +
           amounts.ozone * ozone[k];
  }
};

// Phase functions [1/sr], which do not depend on the wavelength: Rayleigh's, and that of Cornette
// and Shanks (1992) with a mean cosine of 0.703 (OPAC).
double molecule_phase(double cos_theta);
double aerosol_phase(double cos_theta);

// The integral of a phase function times the Legendre polynomial P1 or P2.
struct PhaseMoments {
  double first;
  double second;
};
PhaseMoments molecule_moments();
PhaseMoments aerosol_moments();

// Linear Rec. 709 of light whose spectrum is `share` of the sun's outside the atmosphere (ASTM
// G-173) [W/m^2, or W/(sr m^2) for shares per sr], in the RGB watts of lumens_per_watt. Channels
// outside the gamut are negative.
glm::dvec3 rec709_of_sunlight(const Spectrum& share);

// A reflectance per channel as a spectrum.
Spectrum reflectance_spectrum(const glm::dvec3& rgb);

// exp(-depth) for depth >= 0: within 0.1% up to depth 5, larger beyond. Compilers vectorize it.
inline double attenuation(double depth) {
  const double x = 0.125 * depth;
  const double growth =
      1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0))));
  const double square = growth * growth;
  const double fourth = square * square;
  return 1.0 / (fourth * fourth);
}

}  // namespace brume
