#pragma once

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "brume/medium.h"
#include "core/transport/optical_depth.h"
#include "tests/random.h"

namespace brume {

// Many small Gaussians in the cube [-1, 1]^3, of a mean optical depth across it.
inline std::vector<Gaussian> fog_bank(std::size_t count, double depth, unsigned seed) {
  Random random(seed);
  std::vector<Gaussian> gaussians;
  double mass = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    Gaussian& g = gaussians.emplace_back();
    g.center = random.point(1.0);
    g.radius = random.uniform(0.03, 0.15);
    g.density = random.uniform(0.5, 1.5);
    mass += std::pow(std::numbers::pi, 1.5) * g.density * std::pow(g.radius, 3);
  }
  for (Gaussian& g : gaussians) g.density *= depth * 4.0 / mass;
  return gaussians;
}

inline Medium medium_of(const std::vector<Gaussian>& gaussians) {
  Medium medium;
  for (const Gaussian& gaussian : gaussians) medium.append(gaussian);
  return medium;
}

// Optical depth of a line of 20 u.
inline double depth_along(std::span<const Gaussian> gaussians, const glm::dvec3& origin,
                          const glm::dvec3& w) {
  double depth = 0.0;
  for (const Gaussian& g : gaussians) {
    depth += optical_depth(g, origin, origin + 20.0 * w);
  }
  return depth;
}

// Up to a constant.
inline double mass_of(std::span<const Gaussian> gaussians) {
  double mass = 0.0;
  for (const Gaussian& g : gaussians) mass += g.density * std::pow(g.mean_radius(), 3);
  return mass;
}

// The relative rms error of optical depth over lines through the middle of the cube.
inline double depth_error(std::span<const Gaussian> from, std::span<const Gaussian> to, int lines) {
  Random random(9);
  double squares = 0.0;
  double errors = 0.0;
  for (int i = 0; i < lines; ++i) {
    const glm::dvec3 w = glm::normalize(random.point(1.0));
    const glm::dvec3 origin = random.point(0.6) - 10.0 * w;
    const double depth = depth_along(from, origin, w);
    const double error = depth_along(to, origin, w) - depth;
    squares += depth * depth;
    errors += error * error;
  }
  return std::sqrt(errors / squares);
}

}  // namespace brume
