#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/paths/path_random.h"

namespace brume {

// Samples points of a medium by the light that Gaussians emit there, channels added up, without
// absorption. Gaussians that emit too much for it, or too little, are left out.
class EmissionSampler {
 public:
  // Empty: nothing emits.
  EmissionSampler() = default;
  explicit EmissionSampler(const MediumIndex& medium);

  [[nodiscard]] bool empty() const { return emitting_.empty(); }
  [[nodiscard]] glm::dvec3 sample(PathRandom& random) const;
  // Density of sample() [1/u^3] where Gaussians of density sum `density` [1/u] have the mean
  // emission `emission`.
  [[nodiscard]] double pdf(double density, const glm::dvec3& emission) const {
    return empty() ? 0.0 : density * (emission.x + emission.y + emission.z) / sums_.back();
  }

 private:
  struct Emitting {
    glm::dvec3 center;
    glm::dmat3 deviation;  // its axes, as long as standard deviations [u]
  };
  std::vector<Emitting> emitting_;
  std::vector<double> sums_;  // of what they emit up to each [W/sr]
};

}  // namespace brume
