// Ellipsoidal Gaussians beside balls: errors of `sliced` against `reference` in random scenes of
// both, on the CPU and with OpenGL, and frame times.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/math/rounded.h"
#include "core/transport/optical_depth.h"
#include "render/gl_renderer.h"
#include "render/renderer.h"
#include "tools/bench/measure/measurement.h"

namespace brume {
namespace {

constexpr std::array slice_counts{8, 16, 32, 64, 128};

class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  glm::dvec3 point() {
    const double x = uniform(-1.0, 1.0);
    const double y = uniform(-1.0, 1.0);
    return {x, y, uniform(-1.0, 1.0)};
  }
  glm::dvec3 in_ball() {
    for (;;) {
      const glm::dvec3 p = point();
      if (glm::dot(p, p) <= 1.0) return p;
    }
  }
  glm::dquat turn() {
    const glm::dvec3 axis = point();
    return glm::normalize(glm::dquat(uniform(-1.0, 1.0), axis.x, axis.y, axis.z));
  }

 private:
  std::mt19937 engine_;
};

// An ellipsoid of the volume of a ball, turned at random, whose radii differ by up to `elongation`.
void stretch(Gaussian& g, double elongation, Numbers& numbers) {
  glm::dvec3 logarithms = 0.5 * std::log(elongation) * numbers.point();
  logarithms -= (logarithms.x + logarithms.y + logarithms.z) / 3.0;
  g.set_radii(g.radius * glm::exp(logarithms), numbers.turn());
}

// With the ball of its volume for each ellipsoid.
Scene as_balls(const Scene& scene) {
  Scene balls = scene;
  balls.medium = {};
  balls.medium.set_homogeneous_density(scene.medium.homogeneous_density());
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    Gaussian g = scene.medium.gaussian(i);
    g.radius = g.mean_radius();
    g.shape = {};
    balls.medium.append(g);
  }
  return balls;
}

// A cloud around the origin, of an optical depth along the view axis.
Scene cloud(std::size_t count, double radius, double depth, double share, double elongation,
            Numbers& numbers) {
  std::vector<Gaussian> gaussians;
  double along_axis = 0.0;
  while (gaussians.size() < count) {
    Gaussian g{numbers.in_ball(), radius * numbers.uniform(0.6, 1.4), numbers.uniform(0.5, 1.5)};
    if (numbers.uniform(0.0, 1.0) < share) stretch(g, elongation, numbers);
    along_axis += optical_depth(g, {0, 0, -10}, {0, 0, 10});
    gaussians.push_back(g);
  }
  Scene scene;
  for (Gaussian& g : gaussians) {
    g.density *= along_axis > 0.0 ? depth / along_axis : 0.0;
    scene.medium.append(g);
  }
  scene.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.lights.push_back({{1.5, 3.0, 2.0}, glm::dvec3(10.0), {}});
  return scene;
}

// Half of its Gaussians are balls.
Scene mixed_scene(unsigned seed) {
  Numbers numbers(seed);
  const auto count = static_cast<std::size_t>(std::pow(10.0, numbers.uniform(1.0, 2.4)));
  const double radius = numbers.uniform(0.1, 0.4);
  const double depth = std::pow(10.0, numbers.uniform(-0.5, 0.8));
  const double elongation = std::pow(10.0, numbers.uniform(0.3, 2.0));
  Scene scene = cloud(count, radius, depth, 0.5, elongation, numbers);
  scene.lights[0].position = 3.0 * numbers.point();
  if (seed % 3 == 0) scene.optics.anisotropy = numbers.uniform(-0.6, 0.7);
  if (seed % 4 == 0) scene.medium.set_homogeneous_density(0.03);
  // Every fifth with the eye among them.
  if (seed % 5 == 0) scene.camera.eye = {0.3, 0.2, 0.5};
  scene.film = {120, 90};
  return scene;
}

// The median and the greatest.
std::string of_scenes(std::vector<double> errors) {
  if (errors.empty()) return "";
  const Spread spread = spread_of(std::move(errors));
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%g%% (%g)", rounded(100.0 * spread.median, 2),
                rounded(100.0 * spread.max, 2));
  return text.data();
}

void report_errors(unsigned scenes) {
  std::string problem;
  const std::unique_ptr<GlRenderer> gl = GlRenderer::create(nullptr, problem);
  std::array<std::array<std::vector<double>, 3>, slice_counts.size()> errors;
  for (unsigned seed = 1; seed <= scenes; ++seed) {
    const Scene scene = mixed_scene(seed);
    const Scene balls = as_balls(scene);
    const ReferenceSample reference = find_reference(scene, 60, 1e-4);
    const ReferenceSample of_balls = find_reference(balls, 60, 1e-4);
    Renderer renderer;
    for (std::size_t k = 0; k < slice_counts.size(); ++k) {
      const Settings settings = sliced_settings({}, slice_counts[k]);
      const auto error = [&](FrameRenderer& by, const Scene& of, const ReferenceSample& right) {
        return right.sample.measure(*by.render(of, of.camera, of.film, settings)).rel_rmse;
      };
      errors[k][0].push_back(error(renderer, balls, of_balls));
      errors[k][1].push_back(error(renderer, scene, reference));
      if (gl) errors[k][2].push_back(error(*gl, scene, reference));
    }
    std::fprintf(stderr, "\rscene %u of %u", seed, scenes);
  }
  std::fprintf(stderr, "\n");
  if (gl) std::printf("OpenGL: %s.\n\n", gl->device_name().c_str());
  std::printf("| `sliced` | balls | ellipsoids | ellipsoids, OpenGL |\n|---|---|---|---|\n");
  for (std::size_t k = 0; k < slice_counts.size(); ++k) {
    std::printf("| %d | %s | %s | %s |\n", slice_counts[k], of_scenes(errors[k][0]).c_str(),
                of_scenes(errors[k][1]).c_str(), of_scenes(errors[k][2]).c_str());
  }
}

// Frame times of ellipsoids over those of balls, each pair in turn, and the pairs of Gaussians and
// rays.
struct Cost {
  Spread time;
  double pairs = 0.0;
};

Cost cost_of(const Scene& scene, const Settings& settings, int frames) {
  const std::array scenes{as_balls(scene), scene};
  std::array<Renderer, 2> renderers;
  std::vector<double> ratios;
  Cost cost;
  for (int i = 0; i <= frames; ++i) {
    std::array<FrameStatistics, 2> statistics;
    for (std::size_t k = 0; k < 2; ++k) {
      const Camera camera = moved(scenes[k].camera, {0.5, 1}, i);
      statistics[k] = renderers[k].render(scenes[k], camera, scenes[k].film, settings)->statistics;
    }
    const auto& [balls, ellipsoids] = statistics;
    if (i > 0) ratios.push_back(ellipsoids.frame_milliseconds / balls.frame_milliseconds);
    cost.pairs = static_cast<double>(ellipsoids.view_pairs) / static_cast<double>(balls.view_pairs);
  }
  cost.time = spread_of(std::move(ratios));
  return cost;
}

void report_times(int frames) {
  std::printf("\n| Gaussians | radii up to | `sliced` 24 | pairs | `paper` | pairs |\n");
  std::printf("|---|---|---|---|---|---|\n");
  for (const std::size_t count : {300u, 3000u, 30000u}) {
    for (const double elongation : {3.0, 10.0, 30.0}) {
      Numbers numbers(7);
      const double radius = 0.2 * std::cbrt(300.0 / static_cast<double>(count));
      Scene scene = cloud(count, radius, 3.0, 1.0, elongation, numbers);
      scene.film = {400, 300};
      Settings settings = sliced_settings({}, 24);
      settings.merge_error = 0.0;
      Settings paper = settings;
      paper.airlight = AirlightMethod::paper;
      std::printf("| %zu | %g : 1 |", count, elongation);
      for (const Settings& method : {settings, paper}) {
        const Cost cost = cost_of(scene, method, frames);
        std::printf(" %.2f (%.2f to %.2f) | %.2f |", cost.time.median, cost.time.min, cost.time.max,
                    cost.pairs);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace brume

int main(int count, char** arguments) {
  const int scenes = count > 1 ? std::atoi(arguments[1]) : 100;
  if (scenes < 1 || scenes > 10000) {
    std::fprintf(stderr, "usage: brume-ellipsoid-report [SCENES from 1 to 10000, default 100]\n");
    return 2;
  }
  brume::report_errors(static_cast<unsigned>(scenes));
  brume::report_times(scenes < 100 ? 3 : 15);
}
