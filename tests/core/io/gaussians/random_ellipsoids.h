#pragma once

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

// Ellipsoids of all shapes, some of them balls, and some without density.
inline std::vector<Gaussian> random_ellipsoids(std::size_t count, unsigned seed = 7) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-10.0, 10.0);
  std::uniform_real_distribution<double> exponent(-2.0, 1.0);
  std::normal_distribution<double> normal;
  const auto size = [&] { return std::pow(10.0, exponent(random)); };
  std::vector<Gaussian> gaussians;
  for (std::size_t i = 0; i < count; ++i) {
    Gaussian& g = gaussians.emplace_back(
        Gaussian{{coordinate(random), coordinate(random), coordinate(random)}, size()});
    g.density = i % 9 == 8 ? 0.0 : size() / g.radius;
    if (i % 5 == 4) continue;
    const glm::dquat turned(normal(random), normal(random), normal(random), normal(random));
    g.set_radii({size(), size(), size()}, glm::normalize(turned));
  }
  return gaussians;
}

// The largest difference of the two ellipsoids' centers, radii and axes [1], of a diameter.
inline double shape_difference(const Gaussian& a, const Gaussian& b) {
  const double size = 2.0 * b.radius;
  double largest = glm::length(a.center - b.center) / size;
  const glm::dmat3 a_axes = warp(a.shape);
  const glm::dmat3 b_axes = warp(b.shape);
  double warp_size = 0.0;
  double warp_difference = 0.0;
  for (int k = 0; k < 3; ++k) {
    warp_size += glm::dot(b_axes[k], b_axes[k]);
    warp_difference += glm::dot(a_axes[k] - b_axes[k], a_axes[k] - b_axes[k]);
  }
  largest = std::max(largest, std::sqrt(warp_difference / warp_size));
  return std::max(largest, std::abs(a.radius - b.radius) / size);
}

}  // namespace brume
