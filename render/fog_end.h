#pragma once

#include <glm/vec3.hpp>

#include "core/scene/scene.h"

namespace brume {

// Where homogeneous fog ends. Alone it is endless, and endless fog would hide every environment: in
// an environment it ends at the distance D that eq. 26 asks for, the diagonal of the box around
// surfaces and Gaussians (3 radii of each), or 1 / b0 where there are none.
class FogEnd {
 public:
  explicit FogEnd(const Scene& scene);

  // D, for points of the scene [u]; +inf where fog is endless, or there is none.
  [[nodiscard]] double of_surfaces() const { return distance_; }
  // The optical depth of fog of density b0 [1/u] up to there; 0 without fog.
  [[nodiscard]] double depth_of_surfaces(double b0) const {
    return b0 > 0.0 ? b0 * distance_ : 0.0;
  }
  // What a view ray without a hit is cut off at: D behind the middle of the scene.
  [[nodiscard]] double of_rays(const glm::dvec3& eye) const;

 private:
  glm::dvec3 middle_{0.0};
  double distance_;
};

}  // namespace brume
