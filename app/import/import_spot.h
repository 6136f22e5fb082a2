#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "brume/mesh_arrays.h"

namespace brume {

// A spot for something that is imported: it stands on a plane, or its middle is at a point in the
// air.
struct ImportSpot {
  glm::dvec3 point{0.0};
  glm::dvec3 normal{0.0};  // of the plane, unit, to where there is room; 0: in the air

  // The shift that brings what is in a box there.
  [[nodiscard]] glm::dvec3 shift_of(const MeshBox& box) const {
    const glm::dvec3 half = 0.5 * (box.high - box.low);
    return point + glm::dot(glm::abs(normal), half) * normal - (box.low + half);
  }
};

}  // namespace brume
