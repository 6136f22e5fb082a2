#include "core/medium/splat.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brume {
namespace {

constexpr int max_spheres_per_axis = 3;

// How many deviations long n equal Gaussians are whose middles are two apart.
double length_of(int n) {
  return std::sqrt(1.0 + (n * n - 1) / 3.0);
}

// A row of `count` equal Gaussians, `length` deviations long: how far apart they are, over that.
struct Row {
  int count = 1;
  double spacing = 0.0;

  explicit Row(double length) {
    constexpr double as_round = 1.25;
    if (length < as_round) return;
    while (count < max_spheres_per_axis && length_of(count) < length) ++count;
    spacing = std::sqrt(12.0 * (length * length - 1.0) / (count * count - 1));
  }
  [[nodiscard]] double place(int i) const { return (i - 0.5 * (count - 1)) * spacing; }
};

// The deviation of each ball.
double common_deviation(const glm::dvec3& s) {
  const double min_deviation = std::max(
      std::min({s.x, s.y, s.z}), std::max({s.x, s.y, s.z}) / length_of(max_spheres_per_axis));
  // That of axes that differ little is theirs together.
  double logarithms = 0.0;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    if (s[k] > 1.25 * min_deviation) continue;
    logarithms += std::log(std::max(s[k], min_deviation));
    ++count;
  }
  return count > 0 ? std::exp(logarithms / count) : min_deviation;
}

}  // namespace

Gaussian equivalent_sphere(const Splat& splat) {
  const glm::dvec3& s = splat.deviations;
  const double radius =
      std::numbers::sqrt2 * std::exp((std::log(s.x) + std::log(s.y) + std::log(s.z)) / 3.0);
  return {splat.center, radius, splat.depth * std::numbers::inv_sqrtpi / radius};
}

std::vector<Gaussian> sphere_approximation(const Splat& splat) {
  const Gaussian sphere = equivalent_sphere(splat);
  const double deviation = common_deviation(splat.deviations);
  const Row x(splat.deviations.x / deviation);
  const Row y(splat.deviations.y / deviation);
  const Row z(splat.deviations.z / deviation);
  const int count = x.count * y.count * z.count;
  if (count == 1) return {sphere};
  const double radius = std::numbers::sqrt2 * deviation;
  const double density = sphere.density * std::pow(sphere.radius / radius, 3.0) / count;
  std::vector<Gaussian> spheres;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 place(x.place(i % x.count), y.place(i / x.count % y.count),
                           z.place(i / (x.count * y.count)));
    spheres.push_back({splat.center + splat.rotation * (deviation * place), radius, density});
  }
  return spheres;
}

}  // namespace brume
