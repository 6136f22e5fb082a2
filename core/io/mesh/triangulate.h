#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/io/mesh/mesh_readers.h"

namespace brume {

// The triangles of a mesh's polygons, in their order.
struct Triangulation {
  std::vector<glm::uvec3> triangles;    // three different vertices each, wound as their polygon
  std::vector<std::uint32_t> polygons;  // whose triangle each is
};

// A polygon is a fan around its first corner where that covers it, as that of convex ones does, and
// is cut by ear clipping (Meisters, "Polygons have ears", 1975) elsewhere. Flat and simple ones are
// covered exactly; holes may be joined to the outline by an edge that is passed twice. Others are
// cut in their mean plane, as well as that goes.
Triangulation triangulate(const RawMesh& mesh);

}  // namespace brume
