#include "tools/bench/scenes/benchmark_scenes.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "core/io/disk/installed_files.h"
#include "core/io/scene/scene_file.h"
#include "core/math/random_source.h"
#include "core/scene/lights/radiance_map.h"
#include "core/transport/medium_summary.h"
#include "render/quality/error_estimate.h"
#include "tools/bench/scenes/hash_random.h"

namespace brume {

std::filesystem::path sample_scene_file(const std::string& name) {
  return resources_folder() / "scenes" / (name + ".brume");
}

Scene sample_airlight(const char* name) {
  Scene scene = load_scene(sample_scene_file(name));
  scene.surfaces.clear();
  return scene;
}

Scene two_gaussians() {
  Scene scene;
  scene.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.lights.push_back({{2, 3, 2}, {10, 10, 10}, {}});
  scene.medium.append({{-0.3, 0.1, 0}, 0.6, 2.0});
  scene.medium.append({{0.4, -0.1, 0.2}, 0.5, 2.5});
  return scene;
}

Scene cloud(int count, double depth, std::uint64_t seed, double radius) {
  HashRandom random(seed);
  std::vector<Gaussian> gaussians;
  gaussians.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    gaussians.push_back({random.in_ball(), radius, random.uniform(0.5, 1.5)});
  }
  Scene scene;
  scene.medium = with_depth(gaussians, depth);
  scene.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.film = {200, 150};
  scene.lights.push_back({{1.5, 3.0, 2.0}, {10, 10, 10}, {}});
  return scene;
}

Medium with_depth(std::span<const Gaussian> gaussians, double depth) {
  const auto scaled = [&](double factor) {
    Medium medium;
    medium.reserve(gaussians.size());
    for (Gaussian g : gaussians) {
      g.density *= factor;
      medium.append(g);
    }
    return medium;
  };
  return scaled(depth / summarize(scaled(1.0)).max_optical_depth);
}

Medium box_of(int count) {
  HashRandom random(1);
  const double radius = 0.05 * std::sqrt(1000.0 / count);
  const double depth = 3.0;
  Medium medium;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 center = glm::dvec3(0.5) + random.point(0.5);
    // n pi^(3/2) r^3 c is the depth through the box of cross-section 1.
    medium.append({center, radius, depth / (count * 5.568327996831708 * std::pow(radius, 3))});
  }
  return medium;
}

Scene fog_bank(int count) {
  RandomSource random(1);
  Scene scene;
  scene.camera = {{0, 1, 7}, {0, 0, 0}, {0, 1, 0}, 45.0};
  scene.film = {800, 600};
  scene.lights.push_back({{3, 4, 3}, {60, 50, 40}, {}});
  std::vector<Gaussian> gaussians;
  double mass = 0.0;
  for (int i = 0; i < count; ++i) {
    Gaussian& g = gaussians.emplace_back();
    const auto uniform_in = [&](double low, double high) {
      return low + (high - low) * random.uniform();
    };
    g.center.x = uniform_in(-2.0, 2.0);
    g.center.y = uniform_in(-1.0, 1.0);
    g.center.z = uniform_in(-2.0, 2.0);
    g.radius = uniform_in(0.01, 0.05);
    g.density = uniform_in(0.5, 1.5);
    mass += std::pow(std::numbers::pi, 1.5) * g.density * g.radius * g.radius * g.radius;
  }
  // An optical depth of 2 over the 4 u along a view ray, in 32 u^3.
  for (Gaussian& g : gaussians) {
    g.density *= 0.5 * 32.0 / mass;
    scene.medium.append(g);
  }
  return scene;
}

Scene box_scene(int count, int lights) {
  Scene scene;
  scene.medium = box_of(count);
  scene.camera = {{0.5, 0.5, 3.0}, {0.5, 0.5, 0.5}, {0, 1, 0}, 35.0};
  scene.film = {200, 150};
  for (int i = 0; i < lights; ++i) {
    const double angle = 0.9 + 0.7 * i;
    scene.lights.push_back(
        {{0.5 + 2.5 * std::cos(angle), 3.0, 0.5 + 2.5 * std::sin(angle)}, {10, 10, 10}, {}});
  }
  return scene;
}

namespace {

// radiance(direction) at 2 n by n pixels.
template <class Radiance>
std::shared_ptr<const RadianceMap> sky(int n, Radiance radiance) {
  auto map = std::make_shared<RadianceMap>(RadianceMap{2 * n, n, {}});
  for (int i = 0; i < 2 * n * n; ++i) {
    map->pixels.emplace_back(radiance(map_direction(*map, {i % (2 * n) + 0.5, i / (2 * n) + 0.5})));
  }
  return map;
}

}  // namespace

std::shared_ptr<const RadianceMap> uniform_sky() {
  return sky(8, [](const glm::dvec3&) { return glm::dvec3(1.0); });
}

std::shared_ptr<const RadianceMap> gradient_sky() {
  return sky(32,
             [](const glm::dvec3& d) { return glm::dvec3(0.2, 0.25, 0.3) + std::max(d.y, 0.0); });
}

std::shared_ptr<const RadianceMap> sunny_sky() {
  const glm::dvec3 sun = glm::normalize(glm::dvec3(1.0, 1.5, 0.5));
  return sky(128, [&](const glm::dvec3& d) {
    return glm::dvec3(0.1 + std::max(d.y, 0.0) + (glm::dot(d, sun) > 0.97 ? 20.0 : 0.0));
  });
}

std::shared_ptr<const RadianceMap> low_sun_sky() {
  const glm::dvec3 sun = glm::normalize(glm::dvec3(1.0, 0.06, 0.1));
  return sky(128, [&](const glm::dvec3& d) {
    return glm::dvec3((d.y > 0.0 ? 0.3 : 0.05) + (glm::dot(d, sun) > 0.995 ? 40.0 : 0.0));
  });
}

std::shared_ptr<const RadianceMap> smooth_sky() {
  return sky(32, [](const glm::dvec3& d) {
    return glm::dvec3(1.0 + 0.8 * d.y + 0.3 * d.x * d.z) * glm::dvec3(1, 2, 3);
  });
}

Settings fewest_slices(FrameRenderer& renderer, const Scene& scene) {
  constexpr double error_held = 0.02;
  Settings settings;
  Settings given;
  given.airlight_scale = 4;
  std::optional<ErrorSample> sample;
  for (const int slices : {4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 32, 48, 64, 128}) {
    settings = sliced_settings(given, slices);
    const Frame frame = *renderer.render(scene, scene.camera, scene.film, settings);
    if (!sample) sample = ErrorSample::create(scene, scene.camera, frame, 1000, 1, 1e-3);
    if (sample->measure(frame).high <= error_held) break;
  }
  return settings;
}

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace brume
