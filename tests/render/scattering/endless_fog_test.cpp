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

// The fluence of light that isotropic fog without absorption has scattered, r mean free paths from
// an isotropic point source of unit power, in units of the squared density: the Fourier integral of
// 1 / (2 pi^2 r) k sin(kr) A^2 / (1 - A), A = atan(k) / k (Case, de Hoffmann and Placzek 1953).
double scattered_fluence(double r) {
  const double last = std::max(60.0, 20.0 / r);
  constexpr int steps = 30'000;
  // The integral of 3 sin(kr) / k, which the integrand is at small k, is known.
  double sum = 1.5 * pi;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    const double k = last * u * u;
    if (k < 1e-3) continue;  // the difference is about k there, and cancels
    const double a = std::atan(k) / k;
    sum += 2.0 * last * u / steps * (k * a * a / (1.0 - a) - 3.0 / k) * std::sin(k * r);
  }
  // At large k it is pi^2 / 4 sin(kr) / k.
  const double x = last * r;
  const double beyond = std::cos(x) / x * (1.0 - 2.0 / (x * x)) + std::sin(x) / (x * x);
  sum += (0.25 * pi * pi - 3.0) * beyond;
  return sum / (2.0 * pi * pi * r);
}

// That fluence, interpolated between logarithmic distances.
class ScatteredFluence {
 public:
  ScatteredFluence() {
    for (int i = 0; i <= steps; ++i)
      values_.push_back(std::log(scattered_fluence(std::exp(log_at(i)))));
  }
  double at(double r) const {
    const double place = (std::log(r) - first) / (last - first) * steps;
    if (place >= steps) return 3.0 / (4.0 * pi * r);
    const int i = static_cast<int>(std::max(place, 0.0));
    const auto k = static_cast<std::size_t>(i);
    return std::exp(std::lerp(values_[k], values_[k + 1], place - i));
  }

 private:
  static constexpr int steps = 150;
  static constexpr double first = -5.0, last = 4.0;
  static double log_at(int i) { return first + (last - first) * i / steps; }
  std::vector<double> values_;
};

Scene fog_with_a_lamp(double density) {
  Scene scene;
  scene.film = {1, 1};
  scene.camera = {{0.8, 1.6, 7.0}, {0, 0.8, 0}, {0, 1, 0}, 30.0};
  scene.medium.set_homogeneous_density(density);
  scene.lights = {{{0.0, 0.3, 0.0}, glm::dvec3(1.0), light::Point()}};
  return scene;
}

// From the eye through a target without end, by midpoints.
double exact_airlight(const ScatteredFluence& fluence, const Scene& scene) {
  const double b = scene.medium.homogeneous_density();
  const glm::dvec3 w = glm::normalize(scene.camera.target - scene.camera.eye);
  constexpr double step = 0.01;
  double sum = 0.0;
  for (double t = 0.5 * step; b * t < 20.0; t += step) {
    const double r = glm::length(scene.camera.eye + t * w - scene.lights[0].position);
    const double unscattered = std::exp(-b * r) / (r * r);
    sum += step * std::exp(-b * t) * (unscattered / (4.0 * pi) + b * b * fluence.at(b * r));
  }
  return b * sum;
}

// Only the nearest two mean free paths had nodes: in thin fog one cell of them held all that is
// seen, and beyond the last nodes there was nothing: 5 to 18% too little.
TEST(EndlessFog, ScattersALampsLightAsInTheExactSolution) {
  const ScatteredFluence fluence;
  EXPECT_NEAR(fluence.at(50.0), 3.0 / (4.0 * pi * 50.0), 1e-6);
  for (const double density : {0.01, 0.03, 0.1, 0.3}) {
    // In the deepest the nodes around the lamp end in front of the eye.
    const double bound = density < 0.3 ? 0.02 : 0.05;
    for (const glm::dvec3 target : {glm::dvec3(0.0, 1.1, 0.0), {-2.5, 0.5, 0.0}, {2.0, 2.5, 0.0}}) {
      Scene scene = fog_with_a_lamp(density);
      scene.camera.target = target;
      const Frame frame = render_frame(scene, sliced(32, Scattering::multiple));
      const double exact = exact_airlight(fluence, scene);
      EXPECT_NEAR(static_cast<double>(frame.airlight[0]), exact, bound * exact) << density;
    }
  }
}

}  // namespace
}  // namespace brume
