#pragma once

#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace brume {

// An axis-aligned box; empty unless low <= high.
struct Box {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};

  bool operator==(const Box&) const = default;
};

// Its volume [u^3].
inline double volume(const Box& box) {
  const glm::dvec3 sides = box.high - box.low;
  return sides.x * sides.y * sides.z;
}

inline bool contains(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
         glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

}  // namespace brume
