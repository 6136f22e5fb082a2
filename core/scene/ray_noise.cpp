#include "core/scene/ray_noise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "brume/scene.h"

namespace brume {
namespace {

// x modulo the lattice's period; 0 where there is no telling.
double wrapped(double x) {
  constexpr double period = RayNoise::period;
  const double y = x - period * std::floor(x / period);
  return y >= 0.0 && y < period ? y : 0.0;
}

// The gradient of w . A at a place in the lattice, per cell.
glm::dvec3 potential_gradient(const glm::dvec3& cell, const glm::dvec3& w, std::uint32_t key) {
  constexpr double fade[] = {noise_lattice::fade[0], noise_lattice::fade[1],
                             noise_lattice::fade[2]};
  constexpr double slope_factor = noise_lattice::fade_slope;
  // Weights of the two nodes along each axis and their derivatives.
  double weight[3][2];
  double slope[3][2];
  double offset[3];
  std::uint32_t first[3];
  for (int j = 0; j < 3; ++j) {
    const double floor = std::floor(cell[j]);
    const double f = cell[j] - floor;
    first[j] = static_cast<std::uint32_t>(floor);
    offset[j] = f;
    weight[j][1] = f * f * f * (f * (fade[0] * f + fade[1]) + fade[2]);
    weight[j][0] = 1.0 - weight[j][1];
    slope[j][1] = slope_factor * f * f * (f - 1.0) * (f - 1.0);
    slope[j][0] = -slope[j][1];
  }
  constexpr std::uint32_t last = RayNoise::period - 1;
  glm::dvec3 sum(0.0);
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const std::uint32_t c[3] = {corner & 1, (corner >> 1) & 1, corner >> 2};
    const std::uint32_t bits = noise_lattice::hash(
        key ^ noise_lattice::node((first[0] + c[0]) & last, (first[1] + c[1]) & last,
                                  (first[2] + c[2]) & last));
    glm::dvec3 gradient(0.0);
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) gradient[j] += (bits << (3 * k + j)) >> 31 ? -w[k] : w[k];
    }
    const glm::dvec3 from_node(offset[0] - c[0], offset[1] - c[1], offset[2] - c[2]);
    const double height = glm::dot(gradient, from_node);
    const double wx = weight[0][c[0]];
    const double wy = weight[1][c[1]];
    const double wz = weight[2][c[2]];
    sum += wx * wy * wz * gradient + height * glm::dvec3(slope[0][c[0]] * wy * wz,
                                                         wx * slope[1][c[1]] * wz,
                                                         wx * wy * slope[2][c[2]]);
  }
  return sum;
}

}  // namespace

RayNoise::RayNoise(const Noise& noise, double time)
    : amplitude_(std::min(noise.amplitude, 1e6)),
      frequency_(noise.frequency),
      drift_(noise.velocity * time),
      key_(noise_lattice::hash(
          static_cast<std::uint32_t>(noise.seed) ^
          noise_lattice::hash(static_cast<std::uint32_t>(noise.seed >> 32) + 0x9e3779b9U))) {}

glm::dvec3 RayNoise::cell(const glm::dvec3& x) const {
  const glm::dvec3 c = frequency_ * (x - drift_);
  return {wrapped(c.x), wrapped(c.y), wrapped(c.z)};
}

glm::dvec3 RayNoise::shift(const glm::dvec3& x, const glm::dvec3& w) const {
  return amplitude_ / noise_lattice::rms * glm::cross(w, potential_gradient(cell(x), w, key_));
}

}  // namespace brume
