#include "render/quality/sample_probabilities.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/math/max_component.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/lights/radiance_map.h"
#include "core/transport/optical_depth.h"
#include "render/prepare/light_pixels.h"

namespace brume {
namespace {

// A Gaussian of at most a few pixels, which a frame may miss: the pixel nearest to its center
// (row-major index) and the radiance it may add there, estimated without occlusion.
struct SmallGaussian {
  std::size_t pixel;
  double change;
};

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

// The Gaussians that may change the guide by at least `min_change` > 0, in descending order, at
// most `max_count`.
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

constexpr double uniform_fraction = 0.3;
constexpr double bright_fraction = 0.35;
constexpr double gradient_fraction = 0.35;

// A small Gaussian that may cause a relative error of 0.3% is always sampled.
constexpr double change_that_counts = 3e-3;

std::vector<double> squared_radiance(const CenterLight& light) {
  std::vector<double> squares(light.pixels());
  for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = light.square(i);
  return squares;
}

// The squared difference to the neighbour that differs most.
std::vector<double> squared_steps(const CenterLight& light) {
  const auto width = static_cast<std::size_t>(light.film.width);
  std::vector<double> steps(light.pixels(), 0.0);
  const auto compare = [&](std::size_t i, std::size_t j) {
    const glm::dvec3 step = light.at(i) - light.at(j);
    const double square = glm::dot(step, step);
    steps[i] = std::max(steps[i], square);
    steps[j] = std::max(steps[j], square);
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i % width != 0) compare(i, i - 1);
    if (i >= width) compare(i, i - width);
  }
  return steps;
}

// Pixels nearest to lights in view, up to a limit; beyond it those of the brightest lights. The
// distance at which the nearest ray passes a light grows with the light's distance.
std::vector<glm::ivec2> pixels_of_lights(const Scene& scene, const CameraRays& rays,
                                         const Film& film, std::size_t max_pixels) {
  for (const int width : {3, 2, 1}) {
    std::vector<glm::ivec2> pixels = light_pixels(point_lights(scene), rays, film, width);
    if (pixels.size() <= max_pixels) return pixels;
  }
  std::vector<PointLight> lights = point_lights(scene);
  std::ranges::stable_sort(lights, std::greater(), [&](const PointLight& light) {
    return std::max({light.intensity.x, light.intensity.y, light.intensity.z}) /
           (rays.is_parallel() ? 1.0 : glm::length(light.position - rays.eye()));
  });
  std::vector<glm::ivec2> pixels;
  for (const PointLight& light : lights) {
    for (const glm::ivec2& pixel : light_pixels({&light, 1}, rays, film, 1)) {
      if (pixels.size() < max_pixels) pixels.push_back(pixel);
    }
  }
  return pixels;
}

// Scales chances so that they add up to `count` with none above 1.
void fill(std::vector<double>& probabilities, double count) {
  count = std::min(count, static_cast<double>(probabilities.size()));
  // Each round clamps probabilities above 1 and redistributes the excess.
  for (int round = 0; round < 20; ++round) {
    double certain = 0.0;
    double open = 0.0;
    for (const double probability : probabilities)
      (probability >= 1.0 ? certain : open) += std::min(probability, 1.0);
    if (!(open > 0.0)) break;
    const double scale = (count - certain) / open;
    bool changed = false;
    for (double& probability : probabilities) {
      if (probability >= 1.0) {
        probability = 1.0;
      } else {
        probability *= scale;
        changed = changed || probability >= 1.0;
      }
    }
    if (!changed) break;
  }
  for (double& probability : probabilities) probability = std::clamp(probability, 0.0, 1.0);
}

}  // namespace

std::vector<double> sample_probabilities(const Scene& scene, const Camera& camera,
                                         const Frame& guide, std::size_t count, Measured measured) {
  const CameraRays rays(camera, guide.film);
  const std::vector<double> uniform(guide.depth.size(), 1.0);
  std::vector<double> probabilities(uniform.size(), 0.0);
  const auto add = [&](const std::vector<double>& measure, double fraction) {
    const double sum = std::accumulate(measure.begin(), measure.end(), 0.0);
    if (!(sum > 0.0)) return sum;
    const double scale = fraction * static_cast<double>(count) / sum;
    for (std::size_t i = 0; i < probabilities.size(); ++i) probabilities[i] += scale * measure[i];
    return sum;
  };
  add(uniform, uniform_fraction);
  const bool has_picture = measured == Measured::airlight_and_picture;
  const double share = has_picture ? 0.5 : 1.0;
  const auto add_light = [&](const CenterLight& light) {
    add(squared_steps(light), share * gradient_fraction);
    return add(squared_radiance(light), share * bright_fraction);
  };
  const double sum = add_light(CenterLight::airlight(guide));
  if (has_picture) add_light(CenterLight::picture(guide));
  for (const glm::ivec2& pixel : pixels_of_lights(scene, rays, guide.film, count / 4)) {
    probabilities[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(guide.film.width) +
                  static_cast<std::size_t>(pixel.x)] = 1.0;
  }
  const double min_change = std::max(change_that_counts * std::sqrt(sum), 1e-300);
  for (const SmallGaussian& small : small_gaussians(scene, rays, guide, min_change, count / 4)) {
    probabilities[small.pixel] = 1.0;
  }
  fill(probabilities, static_cast<double>(count));
  return probabilities;
}

}  // namespace brume
