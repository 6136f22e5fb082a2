#include "core/scene/atmosphere/air.h"

#include <algorithm>
#include <cmath>

#include "core/math/color_matching.h"
#include "core/math/sphere_rule.h"

namespace brume {
namespace {

using std::numbers::pi;

constexpr double molecule_height = 8.0;  // [km]
constexpr double aerosol_height = 1.2;   // [km]
constexpr double ozone_middle = 25.0;    // [km]
constexpr double ozone_half_width = 15.0;

constexpr double first_wavelength = 380.0;  // [nm]
constexpr double spectrum_step = 30.0;

// Means over 10 nm from 380 nm on. The sun outside the atmosphere, ASTM G-173 [W/(m^2 nm)]; the
// cross-section of ozone at 233 K, Gorshelev et al. 2014 and Serdyuchenko et al. 2014 [m^2]; both
// as in Bruneton (2017).
constexpr double bin_width = 10.0;
constexpr std::array solar_irradiance{
    1.01249, 1.14716, 1.72765, 1.73054, 1.6887, 1.61253, 1.91198, 2.03474, 2.02042,
    2.02212, 1.93377, 1.95809, 1.91686, 1.8298, 1.8685,  1.8931,  1.85149, 1.8504,
    1.8341,  1.8345,  1.8147,  1.78158, 1.7533, 1.6965,  1.68194, 1.64654, 1.6048,
    1.52143, 1.55622, 1.5113,  1.474,   1.4482, 1.41018, 1.36775, 1.34188, 1.31429};
constexpr std::array ozone_cross_section{
    2.818e-28, 6.636e-28, 1.527e-27, 2.763e-27, 5.52e-27,  8.451e-27, 1.582e-26, 2.316e-26,
    3.669e-26, 4.924e-26, 7.752e-26, 9.016e-26, 1.48e-25,  1.602e-25, 2.139e-25, 2.755e-25,
    3.091e-25, 3.5e-25,   4.266e-25, 4.672e-25, 4.398e-25, 4.701e-25, 5.019e-25, 4.305e-25,
    3.74e-25,  3.215e-25, 2.662e-25, 2.238e-25, 1.852e-25, 1.473e-25, 1.209e-25, 9.423e-26,
    7.455e-26, 6.566e-26, 5.105e-26, 4.15e-26};
static_assert(solar_irradiance.size() == ozone_cross_section.size());

double bin_of(const auto& bins, double nm) {
  const double place = (nm - first_wavelength) / bin_width;
  const auto bin = static_cast<std::ptrdiff_t>(std::floor(place));
  return bins[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(bin, 0, std::ssize(bins) - 1))];
}

double molecule_depth(double nm) {
  const double square = 1e6 / (nm * nm);  // [1/um^2]
  return 0.008569 * square * square * (1.0 + square * (0.0113 + 0.00013 * square));
}

// The asymmetry parameter of Cornette and Shanks, whose mean cosine is
// 3 g (4 + g^2) / (5 (2 + g^2)).
constexpr double asymmetry = 0.6404;

PhaseMoments moments_of(double (*phase)(double)) {
  const QuadratureRule rule = gauss_legendre(64);
  PhaseMoments moments{};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double x = rule.nodes[i];
    const double share = 2.0 * pi * rule.weights[i] * phase(x);
    moments.first += share * x;
    moments.second += share * (1.5 * x * x - 0.5);
  }
  return moments;
}

// The light of each wavelength: of spectra that are cubics (Catmull and Rom) between them.
std::array<glm::dvec3, spectrum_size> sunlight_weights() {
  std::array<glm::dvec3, spectrum_size> weights{};
  const auto add = [&weights](std::ptrdiff_t k, const glm::dvec3& share) {
    k = std::clamp<std::ptrdiff_t>(k, 0, std::ssize(weights) - 1);
    weights[static_cast<std::size_t>(k)] += share;
  };
  constexpr double last = first_wavelength + bin_width * solar_irradiance.size();
  for (double nm = first_wavelength + 0.5; nm < last; nm += 1.0) {
    const glm::dvec3 light = bin_of(solar_irradiance, nm) * rec709_of_wavelength(nm);
    const double place = (nm - first_wavelength) / spectrum_step;
    const auto k = static_cast<std::ptrdiff_t>(place);
    const double t = place - static_cast<double>(k);
    add(k - 1, 0.5 * t * (-1.0 + t * (2.0 - t)) * light);
    add(k, (1.0 + 0.5 * t * t * (3.0 * t - 5.0)) * light);
    add(k + 1, 0.5 * t * (1.0 + t * (4.0 - 3.0 * t)) * light);
    add(k + 2, 0.5 * t * t * (t - 1.0) * light);
  }
  return weights;
}

}  // namespace

double wavelength_of(std::size_t k) {
  return first_wavelength + spectrum_step * static_cast<double>(k);
}

AirAmounts air_density(double altitude) {
  const double ozone = 1.0 - std::abs(altitude - ozone_middle) / ozone_half_width;
  return {std::exp(-altitude / molecule_height) / molecule_height,
          std::exp(-altitude / aerosol_height) / aerosol_height,
          std::max(ozone, 0.0) / ozone_half_width};
}

Air::Air(double turbidity) {
  constexpr double ozone_molecules = 300.0 * 2.687e20;  // Dobson units [1/m^2]
  constexpr double scattered = 0.925;
  constexpr double exponent = 1.3;
  const double aerosol_at_550 = (turbidity - 1.0) * molecule_depth(550.0);
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    const double nm = wavelength_of(k);
    molecules[k] = molecule_depth(nm);
    aerosol_extinction[k] = aerosol_at_550 * std::pow(nm / 550.0, -exponent);
    aerosol_scattering[k] = scattered * aerosol_extinction[k];
    ozone[k] = 0.5 * ozone_molecules *
               (bin_of(ozone_cross_section, nm - bin_width) + bin_of(ozone_cross_section, nm));
  }
}

double molecule_phase(double cos_theta) {
  return 3.0 / (16.0 * pi) * (1.0 + cos_theta * cos_theta);
}

double aerosol_phase(double cos_theta) {
  constexpr double g = asymmetry;
  constexpr double factor = 3.0 / (8.0 * pi) * (1.0 - g * g) / (2.0 + g * g);
  const double denominator = 1.0 + g * (g - 2.0 * cos_theta);
  return factor * (1.0 + cos_theta * cos_theta) / (denominator * std::sqrt(denominator));
}

PhaseMoments molecule_moments() {
  return {0.0, 0.1};
}

PhaseMoments aerosol_moments() {
  static const PhaseMoments moments = moments_of(aerosol_phase);
  return moments;
}

glm::dvec3 rec709_of_sunlight(const Spectrum& share) {
  static const auto weights = sunlight_weights();
  glm::dvec3 rgb(0.0);
  for (std::size_t k = 0; k < spectrum_size; ++k) rgb += share[k] * weights[k];
  return rgb;
}

Spectrum reflectance_spectrum(const glm::dvec3& rgb) {
  // About where each primary lies; linear between.
  constexpr double blue = 460.0;
  constexpr double green = 545.0;
  constexpr double red = 610.0;
  Spectrum spectrum;
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    const double nm = wavelength_of(k);
    const double to_green = std::clamp((nm - blue) / (green - blue), 0.0, 1.0);
    const double to_red = std::clamp((nm - green) / (red - green), 0.0, 1.0);
    spectrum[k] = rgb.b + to_green * (rgb.g - rgb.b) + to_red * (rgb.r - rgb.g);
  }
  return spectrum;
}

}  // namespace brume
