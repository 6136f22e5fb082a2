// Light of all orders of a point light in endless fog without surfaces, against the exact solution.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

using std::numbers::pi;

// The fluence of light that isotropic fog has scattered, r mean free paths from an isotropic point
// source of unit power, in units of the squared extinction: the Fourier integral of
// 1 / (2 pi^2 r) k sin(kr) a A^2 / (1 - a A), A = atan(k) / k, with the albedo a (Case, de Hoffmann
// and Placzek 1953).
double scattered_fluence(double r, double albedo) {
  const double last = std::max(60.0, 20.0 / r);
  constexpr int steps = 30'000;
  // Without absorption it is 3 sin(kr) / k at small k, whose integral is known.
  const double known = albedo == 1.0 ? 3.0 : 0.0;
  double sum = 0.5 * known * pi;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    const double k = last * u * u;
    if (k < 1e-3) continue;  // the difference is about k there, and cancels
    const double a = std::atan(k) / k;
    sum += 2.0 * last * u / steps * (k * albedo * a * a / (1.0 - albedo * a) - known / k) *
           std::sin(k * r);
  }
  // At large k it is the albedo times pi^2 / 4 sin(kr) / k.
  const double x = last * r;
  const double beyond = std::cos(x) / x * (1.0 - 2.0 / (x * x)) + std::sin(x) / (x * x);
  sum += (0.25 * albedo * pi * pi - known) * beyond;
  return sum / (2.0 * pi * pi * r);
}

// That fluence, interpolated between logarithmic distances.
class ScatteredFluence {
 public:
  explicit ScatteredFluence(double albedo) {
    for (int i = 0; i <= steps; ++i) {
      const double r = std::exp(first + (last - first) * i / steps);
      values_.push_back(r * scattered_fluence(r, albedo));
    }
  }
  double at(double r) const {
    const double place = (std::log(r) - first) / (last - first) * steps;
    const int i = std::clamp(static_cast<int>(place), 0, steps - 1);
    const auto k = static_cast<std::size_t>(i);
    return std::lerp(values_[k], values_[k + 1], std::clamp(place - i, 0.0, 1.0)) / r;
  }

 private:
  static constexpr int steps = 150;
  static constexpr double first = -5.0, last = 3.0;
  std::vector<double> values_;  // times the distance
};

Scene fog_with_a_lamp(double density) {
  Scene scene;
  scene.film = {1, 1};
  scene.camera = {{0.8, 1.6, 7.0}, {0, 0.8, 0}, {0, 1, 0}, 30.0};
  scene.medium.set_homogeneous_density(density);
  scene.lights = {{{0.0, 0.3, 0.0}, glm::dvec3(1.0), light::Point()}};
  return scene;
}

// The light from the eye through the target without end, by midpoints.
double exact_airlight(const ScatteredFluence& fluence, const Scene& scene) {
  const double scattering = scene.medium.homogeneous_density();
  const double b = scattering / scene.optics.albedo.x;
  const glm::dvec3 w = glm::normalize(scene.camera.target - scene.camera.eye);
  constexpr double step = 0.01;
  double sum = 0.0;
  for (double t = 0.5 * step; b * t < 20.0; t += step) {
    const double r = glm::length(scene.camera.eye + t * w - scene.lights[0].position);
    const double unscattered = std::exp(-b * r) / (r * r);
    sum += step * std::exp(-b * t) * (unscattered / (4.0 * pi) + b * b * fluence.at(b * r));
  }
  return scattering * sum;
}

// Only the nearest two mean free paths had nodes: in thin fog one cell of them held all that is
// seen, and beyond the last nodes there was nothing: 5 to 18% too little.
TEST(EndlessFog, ScattersALampsLightAsInTheExactSolution) {
  struct Case {
    double albedo;
    std::vector<double> densities;
  };
  EXPECT_NEAR(ScatteredFluence(1.0).at(15.0), 3.0 / (4.0 * pi * 15.0), 1e-5);
  const glm::dvec3 targets[] = {{0.0, 1.1, 0.0}, {-2.5, 0.5, 0.0}, {2.0, 2.5, 0.0}};
  std::size_t index = 0;
  for (const auto& [albedo, densities] :
       {Case{1.0, {0.01, 0.03, 0.1, 0.3}}, Case{0.9, {0.03, 0.3}}, Case{0.5, {0.1}}}) {
    const ScatteredFluence fluence(albedo);
    for (const double density : densities) {
      // The nodes around the light end in front of the eye in the deepest fog.
      const double bound = density < 0.3 ? 0.02 : 0.06;
      Scene scene = fog_with_a_lamp(density);
      scene.optics.albedo = glm::dvec3(albedo);
      scene.camera.target = targets[index++ % std::size(targets)];
      const Frame frame = render_frame(scene, all_orders(32, {.nodes = 40'000}));
      const double exact = exact_airlight(fluence, scene);
      EXPECT_NEAR(static_cast<double>(frame.airlight[0]), exact, bound * exact)
          << density << ' ' << albedo;
    }
  }
}

}  // namespace
}  // namespace brume
