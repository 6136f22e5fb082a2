#include "tools/make_scenes/noise.h"

#include <cmath>
#include <glm/common.hpp>
#include <initializer_list>

#include "tools/make_scenes/random.h"

namespace brume {
namespace {

double lattice_value(std::uint64_t seed, std::int64_t x, std::int64_t y, std::int64_t z) {
  std::uint64_t hash = hash64(seed);
  for (const std::int64_t i : {x, y, z}) hash = hash64(hash ^ static_cast<std::uint64_t>(i));
  return 2.0 * unit_from_hash(hash) - 1.0;
}

double value_noise(std::uint64_t seed, const glm::dvec3& point) {
  const glm::dvec3 cell = glm::floor(point);
  const glm::dvec3 f = point - cell;
  const glm::dvec3 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  const auto x = static_cast<std::int64_t>(cell.x);
  const auto y = static_cast<std::int64_t>(cell.y);
  const auto z = static_cast<std::int64_t>(cell.z);
  const auto along_x = [&](int dy, int dz) {
    return std::lerp(lattice_value(seed, x, y + dy, z + dz),
                     lattice_value(seed, x + 1, y + dy, z + dz), s.x);
  };
  const auto along_xy = [&](int dz) { return std::lerp(along_x(0, dz), along_x(1, dz), s.y); };
  return std::lerp(along_xy(0), along_xy(1), s.z);
}

}  // namespace

double fractal_noise(std::uint64_t seed, const glm::dvec3& point, int octaves) {
  double sum = 0.0;
  double weights = 0.0;
  double weight = 1.0;
  double frequency = 1.0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * value_noise(seed + static_cast<std::uint64_t>(octave), point * frequency);
    weights += weight;
    weight *= 0.5;
    frequency *= 2.0;
  }
  return sum / weights;
}

}  // namespace brume
