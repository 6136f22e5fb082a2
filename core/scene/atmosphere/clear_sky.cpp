#include "core/scene/atmosphere/clear_sky.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <optional>

#include "core/math/sphere_rule.h"
#include "core/scene/atmosphere/slant_columns.h"

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

namespace {

using std::numbers::pi;

constexpr int orders = 4;
constexpr int azimuth_count = 6;  // in a half turn
constexpr int polar_angles = 6;   // above and below the horizon
constexpr int path_steps = 16;

using GroundLight = std::vector<Spectrum>;

struct WeightedDirection {
  SkyDirection direction;
  double weight;  // of both sides [sr]
};

// A rule for the sphere, its polar angles split at the horizon of an altitude.
std::vector<WeightedDirection> directions_at(double altitude) {
  static const QuadratureRule rule = gauss_legendre(polar_angles);
  const double horizon = cos_horizon(altitude);
  std::vector<WeightedDirection> directions;
  for (const auto& [low, high] : {std::pair(-1.0, horizon), std::pair(horizon, 1.0)}) {
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double up = 0.5 * (low + high) + 0.5 * (high - low) * rule.nodes[i];
      const double weight = 0.5 * (high - low) * rule.weights[i];
      const double sine = std::sqrt(1.0 - up * up);
      for (int a = 0; a < azimuth_count; ++a) {
        const double azimuth = pi * (a + 0.5) / azimuth_count;
        directions.push_back({{up, sine * std::cos(azimuth)}, weight * 2.0 * pi / azimuth_count});
      }
    }
  }
  return directions;
}

Spectrum between(const GroundLight& light, const RadianceMoments::Place& place) {
  const auto node = static_cast<std::size_t>(place.node);
  Spectrum result;
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    // Logarithms are interpolated, as RadianceMoments does.
    const double lower = std::max(light[node][k], 1e-300);
    const double upper = std::max(light[node + 1][k], 1e-300);
    result[k] = lower * std::pow(upper / lower, place.share);
  }
  return result;
}

// Light of one order.
struct Order {
  RadianceMoments radiance;
  GroundLight ground;

  explicit Order(double sun_zenith)
      : radiance(sun_zenith), ground(static_cast<std::size_t>(radiance.zeniths())) {}
};

// The order after `before`; null: that of sunlight. What the ground sends is of the order after
// what it receives.
Order next_order(const Air& air, const Spectrum& reflectance, double sun_zenith,
                 const Order* before) {
  Order order(sun_zenith);
  tbb::parallel_for(0, RadianceMoments::altitudes, [&](int i) {
    const double altitude = RadianceMoments::altitude(i);
    const auto directions = directions_at(altitude);
    for (int j = 0; j < order.radiance.zeniths(); ++j) {
      const double zenith = order.radiance.sun_zenith(j);
      Moments moments{};
      Spectrum& ground = order.ground[static_cast<std::size_t>(j)];
      for (const auto& [direction, weight] : directions) {
        const SkyRay ray{altitude, zenith, direction};
        const PathLight path = light_along(air, ray, path_steps, before == nullptr,
                                           before ? &before->radiance : nullptr);
        Spectrum radiance;
        const double cos_sun = ray.cos_sun();
        for (std::size_t k = 0; k < spectrum_size; ++k) {
          radiance[k] = path.once(k, cos_sun) + path.again[k];
        }
        if (ray.hits_ground()) {
          const SkyRay end = ray.moved(ray.length());
          Spectrum irradiance;
          if (before) {
            irradiance = between(before->ground, before->radiance.place_of_zenith(end.sun_zenith));
          } else {
            irradiance = sun_irradiance(air, 0.0, end.sun_zenith);
            const double cosine = std::max(std::cos(end.sun_zenith), 0.0);
            for (double& light : irradiance) light *= cosine;
          }
          for (std::size_t k = 0; k < spectrum_size; ++k) {
            radiance[k] += path.transmittance[k] * reflectance[k] / pi * irradiance[k];
          }
        }
        const auto y = even_harmonics(direction);
        for (std::size_t m = 0; m < moment_count; ++m) {
          for (std::size_t k = 0; k < spectrum_size; ++k) {
            moments[m][k] += weight * y[m] * radiance[k];
          }
        }
        if (i == 0 && direction.up > 0.0) {
          for (std::size_t k = 0; k < spectrum_size; ++k) {
            ground[k] += weight * direction.up * radiance[k];
          }
        }
      }
      order.radiance.set(i, j, moments);
    }
  });
  return order;
}

// The factor of the last of the computed orders that stands for it and all after it.
double series_factor(double before, double last) {
  constexpr double max_ratio = 0.95;
  const double ratio = before > 0.0 ? std::clamp(last / before, 0.0, max_ratio) : 0.0;
  return 1.0 / (1.0 - ratio);
}

}  // namespace

ScatteredLight::ScatteredLight(const Air& air, const Spectrum& ground_reflectance,
                               double sun_zenith)
    : radiance(sun_zenith), ground(static_cast<std::size_t>(radiance.zeniths())) {
  std::optional<Order> last;
  for (int n = 1; n <= orders; ++n) {
    Order order = next_order(air, ground_reflectance, sun_zenith, last ? &*last : nullptr);
    const bool is_last = n == orders;
    for (int j = 0; j < order.radiance.zeniths(); ++j) {
      const auto place = static_cast<std::size_t>(j);
      for (std::size_t k = 0; k < spectrum_size; ++k) {
        const double light = order.ground[place][k];
        ground[place][k] += light * (is_last ? series_factor(last->ground[place][k], light) : 1.0);
      }
      for (int i = 0; i < RadianceMoments::altitudes; ++i) {
        const Moments& moments = order.radiance.node(i, j);
        Moments sum = radiance.node(i, j);
        for (std::size_t k = 0; k < spectrum_size; ++k) {
          const double factor =
              is_last ? series_factor(last->radiance.node(i, j)[0][k], moments[0][k]) : 1.0;
          for (std::size_t m = 0; m < moment_count; ++m) sum[m][k] += factor * moments[m][k];
        }
        radiance.set(i, j, sum);
      }
    }
    last = std::move(order);
  }
}

Spectrum ScatteredLight::ground_radiance(const Air& air, const Spectrum& reflectance,
                                         double sun_zenith) const {
  Spectrum light = between(ground, radiance.place_of_zenith(sun_zenith));
  const Spectrum direct = sun_irradiance(air, 0.0, sun_zenith);
  const double cosine = std::max(std::cos(sun_zenith), 0.0);
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    light[k] = reflectance[k] / pi * (light[k] + cosine * direct[k]);
  }
  return light;
}

}  // namespace brume
