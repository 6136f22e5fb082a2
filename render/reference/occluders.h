#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/scene/scene.h"
#include "render/sphere_hierarchy.h"

namespace brume {

// The triangles of a scene as what stands between a light and a view ray. Where Embree answers one
// shadow ray, this answers all shadow rays from a light to a view ray at once, exactly: in the
// plane of light and ray every triangle is a segment, and what it hides is an angle at the light.
class Occluders {
 public:
  explicit Occluders(std::span<const Surface> surfaces);

  [[nodiscard]] bool empty() const { return triangles_.empty(); }

  // The parts [t0, t1] of the view ray eye + t w, t in [0, end], that the light shines on,
  // ascending. Thread-safe.
  [[nodiscard]] std::vector<std::pair<double, double>> lit(const glm::dvec3& light,
                                                           const glm::dvec3& eye,
                                                           const glm::dvec3& w, double end) const;

 private:
  [[nodiscard]] double first_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                                 double end) const;

  using Triangle = std::array<glm::dvec3, 3>;
  std::vector<Triangle> triangles_;
  SphereHierarchy hierarchy_;
};

}  // namespace brume
