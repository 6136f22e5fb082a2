#pragma once

#include <cmath>
#include <cstdlib>
#include <glm/vec3.hpp>
#include <random>
#include <string>

namespace brume {

// Number of random cases that a test tries: `usual`, or BRUME_THOROUGH times as many.
inline unsigned random_cases(unsigned usual) {
  const char* thorough = std::getenv("BRUME_THOROUGH");
  return usual * (thorough ? static_cast<unsigned>(std::stoul(thorough)) : 1u);
}

// Random numbers that are the same on every machine: only the raw generator of the standard
// library is; its distributions are not.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  // 10^x for x uniform in [low, high].
  double power(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  // Uniform in the cube [-size, size]^3.
  glm::dvec3 point(double size) {
    // In this order: the order of a call's arguments is up to the compiler.
    const double x = uniform(-size, size);
    const double y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
  }

 private:
  std::mt19937 engine_;
};

}  // namespace brume
