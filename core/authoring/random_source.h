#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>

namespace brume {

// The chance in brushes and particles: the same numbers from the same seed on every machine, which
// the distributions of the standard library do not promise.
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  // In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  // In the open unit disc, and in the open unit ball, each part as likely as any other of its size.
  glm::dvec2 in_disc();
  glm::dvec3 in_ball();

 private:
  std::mt19937_64 engine_;
};

}  // namespace brume
