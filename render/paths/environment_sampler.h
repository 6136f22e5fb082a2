#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "brume/scene.h"
#include "render/paths/path_random.h"

namespace brume {

// An environment as a light to sample: directions are drawn in proportion to its radiance, constant
// over cells of about a pixel of the map, uniform in solid angle within a cell. A cell counts its
// neighbours as far as bilinear look-ups do, so the density is positive wherever radiance is.
class EnvironmentSampler {
 public:
  // Pixels share cells in larger maps.
  static constexpr int max_cells = 1 << 20;

  // The map must be loaded.
  explicit EnvironmentSampler(const Environment& environment);

  [[nodiscard]] const Environment& environment() const { return environment_; }

  // Incident radiance from a unit direction, RGB.
  [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;

  // Whether there is anything to sample; else it is black.
  [[nodiscard]] bool empty() const { return cells_.empty(); }
  [[nodiscard]] glm::dvec3 sample(PathRandom& random) const;
  // Probability density of sample() [1/sr].
  [[nodiscard]] double pdf(const glm::dvec3& direction) const;

 private:
  // For sampling in constant time: cell i with probability `keep`, else `alias` (Vose 1991).
  struct Cell {
    double keep = 1.0;
    double pdf = 0.0;  // [1/sr]
    std::uint32_t alias = 0;
  };
  void make_aliases(std::vector<double> weights);

  Environment environment_;
  glm::dquat to_world_{1.0, 0.0, 0.0, 0.0};
  int pixels_ = 1;  // side of a cell, in pixels
  int columns_ = 0;
  std::vector<Cell> cells_;  // rows from the top
};

}  // namespace brume
