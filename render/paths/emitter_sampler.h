#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/scene/lights/emitting_surfaces.h"
#include "render/geometry/medium_index.h"
#include "render/paths/path_random.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Draws points of surfaces that emit light, by what their triangles send, channels added up, and
// evenly over each.
class EmitterSampler {
 public:
  // Empty: nothing emits.
  EmitterSampler() = default;
  explicit EmitterSampler(std::span<const Surface> surfaces);

  [[nodiscard]] bool empty() const { return sums_.empty() || !(sums_.back() > 0.0); }

  struct Point {
    glm::dvec3 position{0.0};
    std::uint32_t surface = 0;   // index
    std::uint32_t triangle = 0;  // in its mesh
    std::uint32_t copy = 0;      // see SurfaceHit
  };
  [[nodiscard]] Point sample(PathRandom& random) const;
  // Density of finding, from where the ray came, the point that a ray in the unit direction w hits
  // [1/sr]; 0 where nothing emits.
  [[nodiscard]] double pdf(const SurfaceHit& hit, const glm::dvec3& w) const;

 private:
  std::vector<EmittingTriangle> triangles_;
  std::vector<double> sums_;              // of what they send up to each
  std::vector<std::int64_t> firsts_;      // in triangles_, per surface; < 0: it emits nothing
  std::vector<std::size_t> face_counts_;  // per surface
};

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
