#include "core/scene/lights/photometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/math/color_matching.h"
#include "core/overloaded.h"
#include "core/scene/lights/light_falloff.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/lights/point_lights.h"

namespace brume {
namespace {

constexpr double min_temperature = domain::temperature.min_value;
constexpr double max_temperature = domain::temperature.max_value;

constexpr double second_constant = 1.438776877e7;  // hc / k [nm K]

// Samples of the visible spectrum.
constexpr double wavelength_step = 5.0;  // [nm]
constexpr int wavelength_count = 81;
constexpr double wavelength(int k) {
  return 380.0 + wavelength_step * k;
}

// Linear Rec. 709 of the light at each wavelength, times what does not depend on the temperature in
// Planck's law relative to its value at 560 nm.
std::array<glm::dvec3, wavelength_count> weights_of_wavelengths() {
  std::array<glm::dvec3, wavelength_count> weights{};
  for (int k = 0; k < wavelength_count; ++k) {
    const double nm = wavelength(k);
    weights[static_cast<std::size_t>(k)] = std::pow(560.0 / nm, 5) * rec709_of_wavelength(nm);
  }
  return weights;
}

// A black body's light, linear Rec. 709, relative to its radiance at 560 nm in a wavelength_step:
// at low temperatures the rest is all that remains.
glm::dvec3 relative_black_body(double temperature) {
  static const auto weights = weights_of_wavelengths();
  const auto rest = [&](double nm) { return std::expm1(second_constant / (nm * temperature)); };
  const double at_560 = rest(560.0);
  glm::dvec3 rgb(0.0);
  for (int k = 0; k < wavelength_count; ++k) {
    rgb += at_560 / rest(wavelength(k)) * weights[static_cast<std::size_t>(k)];
  }
  return glm::max(rgb, 0.0);
}

// Evenly in mireds, as the eye tells temperatures apart. `share` of the way from the hottest to the
// coldest.
double temperature_at(double share) {
  return 1.0 / (1.0 / max_temperature + share * (1.0 / min_temperature - 1.0 / max_temperature));
}
double share_of(double temperature) {
  return (1.0 / temperature - 1.0 / max_temperature) /
         (1.0 / min_temperature - 1.0 / max_temperature);
}

// The solid angle of a light, weighted by its falloff.
double solid_angle(const light::Point& point) {
  return point.profile.content ? point.profile.content->solid_angle() : 4.0 * std::numbers::pi;
}

// The falloff of a cone is clamp(x, 0, 1)^2, x linear in the cosine.
double solid_angle_of_cone(const LightFalloff& falloff) {
  const double at_axis = std::min(falloff.dark_versine() * falloff.per_versine(), 1.0);
  const double edge = at_axis * at_axis * at_axis / (3.0 * falloff.per_versine());
  return 2.0 * std::numbers::pi * (std::max(falloff.full_versine(), 0.0) + edge);
}

double solid_angle(const light::Spot& spot) {
  const LightFalloff falloff(spot);
  if (!spot.profile.content) return solid_angle_of_cone(falloff);
  // Rings about the axis of equal angle, and of equal parts.
  constexpr int rings = 360;
  constexpr int parts = 72;
  const double ring = glm::radians(std::min(spot.outer_angle, 180.0)) / rings;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    const double polar = (i + 0.5) * ring;
    for (int k = 0; k < parts; ++k) {
      const double azimuth = 2.0 * std::numbers::pi * (k + 0.5) / parts;
      const glm::dvec3 across =
          std::cos(azimuth) * falloff.azimuth_0() + std::sin(azimuth) * falloff.azimuth_90();
      const glm::dvec3 w = std::cos(polar) * falloff.axis() + std::sin(polar) * across;
      sum += std::sin(polar) * falloff.at(w);
    }
  }
  return sum * ring * 2.0 * std::numbers::pi / parts;
}

}  // namespace

double luminance(const glm::dvec3& rgb) {
  return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double photometric_strength(const Light& light) {
  return lumens_per_watt * luminance(light.intensity);
}

std::optional<double> luminous_flux(const Light& light) {
  using Factor = std::optional<double>;
  const Factor factor =
      std::visit(Overloaded{[](const light::Point& point) { return Factor(solid_angle(point)); },
                            [](const light::Spot& spot) { return Factor(solid_angle(spot)); },
                            [](const light::Directional&) { return Factor(); },
                            [](const AreaLight& area) {
                              const double sides = is_two_sided(area) ? 2.0 : 1.0;
                              return Factor(sides * std::numbers::pi * surface_area(area));
                            }},
                 light.kind);
  return factor ? Factor(photometric_strength(light) * *factor) : Factor();
}

glm::dvec3 black_body_color(double temperature) {
  temperature = std::clamp(temperature, min_temperature, max_temperature);
  const glm::dvec3 rgb = relative_black_body(temperature);
  return rgb / std::max({rgb.x, rgb.y, rgb.z});
}

glm::dvec3 black_body_radiance(double temperature) {
  if (!(temperature >= min_temperature)) return glm::dvec3(0.0);
  temperature = std::min(temperature, max_temperature);
  // Relative to 560 nm it hardly varies; the rest is one exponential.
  constexpr int count = 256;
  static const auto table = [] {
    std::array<glm::dvec3, count + 1> all;
    for (int i = 0; i <= count; ++i) {
      all[static_cast<std::size_t>(i)] = relative_black_body(temperature_at(1.0 * i / count));
    }
    return all;
  }();
  const double place = count * share_of(temperature);
  const int i = std::clamp(static_cast<int>(place), 0, count - 1);
  const auto k = static_cast<std::size_t>(i);
  const glm::dvec3 relative = glm::mix(table[k], table[k + 1], place - i);
  constexpr double first_constant = 1.191042972e20;  // 2 h c^2 [W nm^4/(sr m^2)]
  const double at_560 =
      first_constant / std::pow(560.0, 5) / std::expm1(second_constant / (560.0 * temperature));
  return wavelength_step * at_560 * relative;
}

double nearest_temperature(const glm::dvec3& color) {
  // The nearest of a table, then between its neighbours.
  constexpr int count = 128;
  static const auto colors = [] {
    std::array<glm::dvec3, count + 1> all;
    for (int i = 0; i <= count; ++i) {
      all[static_cast<std::size_t>(i)] = black_body_color(temperature_at(1.0 * i / count));
    }
    return all;
  }();
  const auto nearest = std::ranges::min_element(
      colors, {}, [&](const glm::dvec3& c) { return glm::distance(c, color); });
  const auto i = static_cast<int>(nearest - colors.begin());
  double low = std::max(i - 1, 0) / static_cast<double>(count);
  double high = std::min(i + 1, count) / static_cast<double>(count);
  const auto error = [&](double share) {
    return glm::distance(black_body_color(temperature_at(share)), color);
  };
  for (int k = 0; k < 30; ++k) {
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    if (error(a) < error(b)) {
      high = b;
    } else {
      low = a;
    }
  }
  return temperature_at(0.5 * (low + high));
}

}  // namespace brume
