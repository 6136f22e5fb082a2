#include "core/scene/lights/sky.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/trigonometric.hpp>
#include <mutex>
#include <numbers>

#include "core/scene/atmosphere/clear_sky.h"
#include "core/scene/lights/environment.h"
#include "core/scene/lights/radiance_map.h"

namespace brume {
namespace {

using Parts = ClearSky::Parts;

// Half a turn from the sun's azimuth on: the parts of a row of the sky are even about it. Cubics
// between azimuths (Catmull and Rom).
class SkyRow {
 public:
  SkyRow(const ClearSky& sky, double up) : up_(up), level_(std::sqrt(1.0 - up * up)) {
    for (int i = 0; i <= intervals; ++i) {
      parts_.push_back(sky.parts({up, level_ * std::cos(i * step)}));
    }
  }

  // The azimuth relative to the sun's, in [0, pi].
  [[nodiscard]] Parts at(double azimuth) const {
    const double place = azimuth / step;
    const int i = std::min(static_cast<int>(place), intervals - 1);
    const double t = place - i;
    const double before = 0.5 * t * (-1.0 + t * (2.0 - t));
    const double here = 1.0 + 0.5 * t * t * (3.0 * t - 5.0);
    const double next = 0.5 * t * (1.0 + t * (4.0 - 3.0 * t));
    const double beyond = 0.5 * t * t * (t - 1.0);
    const auto mix = [&](glm::dvec3 Parts::*part) {
      return before * parts(i - 1).*part + here * parts(i).*part + next * parts(i + 1).*part +
             beyond * parts(i + 2).*part;
    };
    return {mix(&Parts::once_by_molecules), mix(&Parts::once_by_aerosol), mix(&Parts::again)};
  }

 private:
  static constexpr int intervals = 18;
  static constexpr double step = std::numbers::pi / intervals;

  [[nodiscard]] const Parts& parts(int i) const {
    i = std::abs(i);
    return parts_[static_cast<std::size_t>(i > intervals ? 2 * intervals - i : i)];
  }

  double up_, level_;
  std::vector<Parts> parts_;
};

// A degree is more than a pixel: the glow around the sun is several degrees wide.
constexpr int map_width = 512;
constexpr int map_height = 256;

// The sun is above the middle column.
RadianceMap map_of(const ClearSky& sky, double elevation) {
  RadianceMap map{
      map_width, map_height,
      std::vector(std::size_t{map_width} * map_height, glm::vec3(sky.ground_radiance()))};
  const double sun_up = std::sin(glm::radians(elevation));
  const double sun_level = std::cos(glm::radians(elevation));
  tbb::parallel_for(0, map_height / 2, [&](int y) {
    const double up = map_direction(map, {0.5 * map_width, y + 0.5}).y;
    const double level = std::sqrt(1.0 - up * up);
    const SkyRow row(sky, up);
    for (int x = 0; x < map_width / 2; ++x) {
      const double azimuth = (x + 0.5) * 2.0 * std::numbers::pi / map_width;
      const double cos_sun = sun_up * up + sun_level * level * std::cos(azimuth);
      const glm::vec3 radiance(sky.radiance_of(row.at(azimuth), cos_sun));
      const int middle = y * map_width + map_width / 2;
      map.pixels[static_cast<std::size_t>(middle + x)] = radiance;
      map.pixels[static_cast<std::size_t>(middle - 1 - x)] = radiance;
    }
  });
  return map;
}

struct SkyLight {
  double elevation;
  double turbidity;
  glm::dvec3 ground_albedo;
  std::shared_ptr<const RadianceMap> map;
  glm::dvec3 sun;  // irradiance

  [[nodiscard]] bool is_of(const Sky& sky) const {
    return elevation == sky.elevation && turbidity == sky.turbidity &&
           ground_albedo == sky.ground_albedo;
  }
};

// The same map for the same sky while it is among the last: what is made of it stays, too.
class SkyCache {
 public:
  SkyLight light_of(const Sky& sky) {
    if (const auto known = find(sky)) return *known;
    const ClearSky computed(sky.elevation, sky.turbidity, sky.ground_albedo);
    return add(sky, {sky.elevation, sky.turbidity, sky.ground_albedo,
                     std::make_shared<const RadianceMap>(map_of(computed, sky.elevation)),
                     computed.sun_irradiance()});
  }

 private:
  static constexpr std::size_t max_skies = 8;

  std::optional<SkyLight> find(const Sky& sky) {
    const std::scoped_lock lock(mutex_);
    return find_locked(sky);
  }
  std::optional<SkyLight> find_locked(const Sky& sky) {
    const auto found =
        std::ranges::find_if(lights_, [&sky](const SkyLight& light) { return light.is_of(sky); });
    if (found == lights_.end()) return std::nullopt;
    SkyLight light = *found;
    lights_.erase(found);
    lights_.push_front(light);
    return light;
  }
  // Another thread may have been faster.
  SkyLight add(const Sky& sky, SkyLight light) {
    const std::scoped_lock lock(mutex_);
    if (const auto known = find_locked(sky)) return *known;
    lights_.push_front(light);
    if (lights_.size() > max_skies) lights_.pop_back();
    return light;
  }

  std::mutex mutex_;
  std::deque<SkyLight> lights_;  // the latest first
};

}  // namespace

glm::dvec3 direction_to_sun(const Environment& environment, const Sky& sky) {
  const double elevation = glm::radians(sky.elevation);
  const double azimuth = glm::radians(sky.azimuth);
  return environment_rotation(environment) * glm::dvec3(std::cos(elevation) * std::sin(azimuth),
                                                        std::sin(elevation),
                                                        -std::cos(elevation) * std::cos(azimuth));
}

void aim_sun(const Environment& environment, const glm::dvec3& direction, Sky& sky) {
  const glm::dvec3 in_sky = glm::conjugate(environment_rotation(environment)) * direction;
  sky.elevation = glm::degrees(std::atan2(in_sky.y, std::hypot(in_sky.x, in_sky.z)));
  sky.azimuth = glm::degrees(std::atan2(in_sky.x, -in_sky.z));
}

const Sky* sun_of_sky(const Scene& scene) {
  const auto& environment = scene.environment;
  return environment && environment->sky && environment->sky->sun ? &*environment->sky : nullptr;
}

void apply_sky(Scene& scene) {
  if (!scene.environment || !scene.environment->sky) return;
  static SkyCache cache;
  Environment& environment = *scene.environment;
  const Sky sky = *environment.sky;
  const SkyLight light = cache.light_of(sky);
  if (sky.sun) {
    scene.lights.push_back({.intensity = environment.intensity * light.sun,
                            .kind = light::Directional{-direction_to_sun(environment, sky),
                                                       glm::degrees(sun_diameter)},
                            .name = "Sun"});
  }
  environment.map = light.map;
  environment.rotation -= sky.azimuth;
  environment.sky.reset();
}

}  // namespace brume
