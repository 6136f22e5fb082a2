#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/scene/lights/emitting_surfaces.h"
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

}  // namespace brume
