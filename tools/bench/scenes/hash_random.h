#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace brume {

// SplitMix64's finaliser: a hash of 64 bits.
inline std::uint64_t hash64(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// A hash as a number in [0, 1).
inline double unit_from_hash(std::uint64_t hash) {
  return static_cast<double>(hash >> 11) * 0x1p-53;
}

// Random numbers that are the same with every compiler and library: the n-th is a hash of seed
// and n, and only exactly rounded operations follow.
class HashRandom {
 public:
  explicit HashRandom(std::uint64_t seed) : seed_(hash64(seed)) {}

  double uniform() { return unit_from_hash(hash64(seed_ + counter_++)); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // Uniform in the cube [-size, size]^3.
  glm::dvec3 point(double size) {
    // In this order: the order of a call's arguments is up to the compiler.
    const double x = uniform(-size, size);
    const double y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
  }

  // Uniform in the unit ball.
  glm::dvec3 in_ball() {
    for (;;) {
      const double x = uniform(-1.0, 1.0);
      const double y = uniform(-1.0, 1.0);
      const double z = uniform(-1.0, 1.0);
      const glm::dvec3 p(x, y, z);
      if (glm::dot(p, p) <= 1.0) return p;
    }
  }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

}  // namespace brume
