#pragma once

#include <glm/vec3.hpp>

namespace brume {

// An axis-aligned box; empty unless low <= high.
struct Box {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};

  bool operator==(const Box&) const = default;
};

}  // namespace brume
