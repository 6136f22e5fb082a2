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

inline bool contains(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
         glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

}  // namespace brume
