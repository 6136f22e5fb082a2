#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>

namespace brume {

// Random numbers for brushes and particles, identical on all platforms, unlike the distributions of
// the standard library.
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  // In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  // Uniform in the open unit disc, and in the open unit ball.
  glm::dvec2 in_disc();
  glm::dvec3 in_ball();

 private:
  std::mt19937_64 engine_;
};

}  // namespace brume
