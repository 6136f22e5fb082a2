#include "core/scene/atmosphere/slant_columns.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

#include "core/math/sphere_rule.h"

namespace brume {
namespace {

// Air from a radius to the top along a ray that rises from it and passes the center at a distance
// [km].
AirAmounts rising_columns(double radius, double passing) {
  static const QuadratureRule rule = gauss_legendre(48);
  const double start = radius - ground_radius;
  const double rise = atmosphere_height - start;
  AirAmounts sum;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    // Altitudes close together at the start, where the air is dense and the ray may be level.
    const double x = 0.5 * (1.0 + rule.nodes[i]);
    const double altitude = start + rise * x * x;
    const double r = ground_radius + altitude;
    const double along = std::sqrt(std::max((r - passing) * (r + passing), 1e-12));
    const double length = rule.weights[i] * rise * x * r / along;
    const AirAmounts density = air_density(altitude);
    sum.molecules += length * density.molecules;
    sum.aerosol += length * density.aerosol;
    sum.ozone += length * density.ozone;
  }
  return sum;
}

// Logarithms of columns over sqrt(altitude) and the root of the height above the horizon.
class ColumnTable {
 public:
  ColumnTable() {
    for (int i = 0; i < altitudes; ++i) {
      const double share = 1.0 * i / (altitudes - 1);
      const double altitude = atmosphere_height * share * share;
      const double lowest = cos_horizon(altitude);
      for (int j = 0; j < angles; ++j) {
        const double root = 1.0 * j / (angles - 1);
        const AirAmounts columns =
            integrated_slant_columns(altitude, lowest + (1.0 - lowest) * root * root);
        const auto logarithm = [](double column) { return std::log(std::max(column, 1e-12)); };
        logarithms_.push_back(
            {logarithm(columns.molecules), logarithm(columns.aerosol), logarithm(columns.ozone)});
      }
    }
  }

  [[nodiscard]] AirAmounts at(double altitude, double cos_zenith) const {
    const double lowest = cos_horizon(altitude);
    const double share = std::sqrt(std::clamp(altitude / atmosphere_height, 0.0, 1.0));
    const double root = std::sqrt(std::clamp((cos_zenith - lowest) / (1.0 - lowest), 0.0, 1.0));
    const double row = share * (altitudes - 1);
    const double column = root * (angles - 1);
    const int i = std::min(static_cast<int>(row), altitudes - 2);
    const int j = std::min(static_cast<int>(column), angles - 2);
    const double s = row - i;
    const double t = column - j;
    const auto* const entry = &logarithms_[static_cast<std::size_t>(i * angles + j)];
    const glm::dvec3 below = entry[0] + t * (entry[1] - entry[0]);
    const glm::dvec3 above = entry[angles] + t * (entry[angles + 1] - entry[angles]);
    const glm::dvec3 logarithm = below + s * (above - below);
    return {std::exp(logarithm.x), std::exp(logarithm.y), std::exp(logarithm.z)};
  }

 private:
  static constexpr int altitudes = 96;
  static constexpr int angles = 160;
  std::vector<glm::dvec3> logarithms_;
};

}  // namespace

double cos_horizon(double altitude) {
  const double radius = ground_radius + altitude;
  return -std::sqrt(std::max(altitude * (radius + ground_radius), 0.0)) / radius;
}

AirAmounts integrated_slant_columns(double altitude, double cos_zenith) {
  const double radius = ground_radius + altitude;
  const double sine = std::sqrt(std::max(1.0 - cos_zenith * cos_zenith, 0.0));
  const double passing = radius * sine;
  const AirAmounts rising = rising_columns(radius, passing);
  if (cos_zenith >= 0.0) return rising;
  // It falls to where it is level first.
  const AirAmounts half = rising_columns(std::max(passing, ground_radius), passing);
  return {2.0 * half.molecules - rising.molecules, 2.0 * half.aerosol - rising.aerosol,
          2.0 * half.ozone - rising.ozone};
}

AirAmounts slant_columns(double altitude, double cos_zenith) {
  static const ColumnTable table;
  return table.at(altitude, cos_zenith);
}

double visible_sun(double altitude, double cos_zenith) {
  const double elevation =
      std::acos(cos_horizon(altitude)) - std::acos(std::clamp(cos_zenith, -1.0, 1.0));
  const double x = std::clamp(elevation / (0.5 * sun_diameter), -1.0, 1.0);
  return 0.5 + (x * std::sqrt(1.0 - x * x) + std::asin(x)) / std::numbers::pi;
}

}  // namespace brume
