#include "render/quality/small_gaussians.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/math/max_component.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/lights/radiance_map.h"
#include "core/transport/optical_depth.h"

namespace brume {
namespace {

// Samples of interpolated airlight are four pixels apart.
constexpr double small_radius = 4.0;

// A Gaussian is negligible beyond this many radii from its center.
constexpr double hidden_radii = 5.0;

// Number of strongest lights that estimate the brightness of Gaussians.
constexpr std::size_t max_lights = 16;

double strength(const PointLight& light) {
  return std::max({light.intensity.x, light.intensity.y, light.intensity.z});
}

std::vector<PointLight> strongest(std::vector<PointLight> lights) {
  std::ranges::sort(lights, std::greater(), strength);  // that of far lights is huge
  lights.resize(std::min(lights.size(), max_lights));
  return lights;
}

double mean_radiance(const Environment& environment) {
  double sum = 0.0;
  for (const glm::vec3& pixel : environment.map->pixels) {
    sum += static_cast<double>(std::max({pixel.x, pixel.y, pixel.z}));
  }
  return environment.intensity * sum / static_cast<double>(environment.map->pixels.size());
}

// Unattenuated light at a Gaussian's center.
double incident(const Gaussian& gaussian, const std::vector<PointLight>& lights,
                double environment_radiance) {
  double sum = environment_radiance;
  for (const PointLight& light : lights) {
    const glm::dvec3 offset = light.position - gaussian.center;
    const double distance = glm::length(offset);
    const double falloff = distance > 0.0 ? light.falloff.at(-offset / distance) : 1.0;
    const double square = std::max(glm::dot(offset, offset), gaussian.radius * gaussian.radius);
    sum += falloff * strength(light) / (4.0 * std::numbers::pi * square);
  }
  return sum;
}

}  // namespace

std::vector<SmallGaussian> small_gaussians(const Scene& scene, const CameraRays& rays,
                                           const Frame& guide, double min_change,
                                           std::size_t max_count) {
  const std::vector<PointLight> lights = strongest(point_lights(scene));
  const double environment_radiance = scene.environment ? mean_radiance(*scene.environment) : 0.0;
  // Pixels; of a pinhole at distance 1.
  const double per_radius =
      rays.is_parallel() ? 1.0 / rays.pixel_width() : 0.5 / std::tan(rays.pixel_half_angle());
  const int width = guide.film.width;
  const int height = guide.film.height;
  std::vector<SmallGaussian> found;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    const Gaussian gaussian = scene.medium.gaussian(i);
    const glm::dvec3 film_position = rays.project(gaussian.center);
    const double distance_of_unit = rays.is_parallel() ? 1.0 : film_position.z;
    if (!(film_position.z > 0.0 &&
          min_component(gaussian.radii()) * per_radius < small_radius * distance_of_unit))
      continue;
    // One whose center is next to the film may still overlap it.
    if (!(film_position.x > -small_radius && film_position.y > -small_radius &&
          film_position.x < width + small_radius && film_position.y < height + small_radius)) {
      continue;
    }
    const int x = std::clamp(static_cast<int>(std::floor(film_position.x)), 0, width - 1);
    const int y = std::clamp(static_cast<int>(std::floor(film_position.y)), 0, height - 1);
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    const double distance = rays.distance_to(gaussian.center);
    if (distance - hidden_radii * gaussian.radius > static_cast<double>(guide.depth[pixel])) {
      continue;  // behind a surface
    }
    const StandaloneTerm term(gaussian);
    const LineProfile<double> line =
        line_profile(*term, rays.origin(x + 0.5, y + 0.5), rays.direction(x + 0.5, y + 0.5));
    const double depth = optical_depth(*term, line, std::numeric_limits<double>::infinity());
    // It adds the light that it scatters and attenuates what is behind it.
    const float* rgb = &guide.center_airlight()[3 * pixel];
    const auto radiance = static_cast<double>(std::max({rgb[0], rgb[1], rgb[2]}));
    const double change =
        -std::expm1(-depth) * std::max(incident(gaussian, lights, environment_radiance), radiance);
    if (change >= min_change) found.push_back({pixel, change});
  }
  max_count = std::min(max_count, found.size());
  std::ranges::partial_sort(found, found.begin() + static_cast<std::ptrdiff_t>(max_count),
                            std::greater(), &SmallGaussian::change);
  found.resize(max_count);
  return found;
}

}  // namespace brume
