#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "brume/scene.h"

namespace brume {

// Where a surface's mesh stands in the world: world = translate + rotate * (scale * mesh). The one
// place where that is written.
struct Placement {
  glm::dvec3 translate;
  glm::dquat rotate;  // unit
  double scale;       // > 0

  explicit Placement(const Surface& surface)
      : translate(surface.translate), rotate(surface.rotate), scale(surface.scale) {}
  explicit Placement(const CopyPlacement& copy)
      : translate(copy.translate), rotate(copy.rotate), scale(copy.scale) {}
  bool operator==(const Placement&) const = default;

  [[nodiscard]] glm::dvec3 point_to_world(const glm::dvec3& p) const {
    return translate + rotate * (scale * p);
  }
  // Keeps the length: the scale is the same along all axes. Directions turn in the same way.
  [[nodiscard]] glm::dvec3 normal_to_world(const glm::dvec3& n) const { return rotate * n; }

  [[nodiscard]] glm::dvec3 point_to_mesh(const glm::dvec3& p) const {
    return vector_to_mesh(p - translate);
  }
  [[nodiscard]] glm::dvec3 vector_to_mesh(const glm::dvec3& v) const {
    return normal_to_mesh(v) / scale;
  }
  [[nodiscard]] glm::dvec3 normal_to_mesh(const glm::dvec3& n) const {
    return glm::conjugate(rotate) * n;
  }
};

// The placements of a surface: the first is its own, the others are those of its copies.
inline std::size_t placement_count(const Surface& surface) {
  return 1 + (surface.placed_copies ? surface.placed_copies->size() : 0);
}
inline Placement placement_of(const Surface& surface, std::size_t copy) {
  return copy == 0 ? Placement(surface) : Placement((*surface.placed_copies)[copy - 1]);
}

}  // namespace brume
