#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/io/mesh/mesh_readers.h"
#include "core/io/mesh/triangulate.h"

namespace brume {

// Unit normals of the vertices of a mesh: the file's, else the sum of those of the triangles
// around, weighted by area; 0 where that is 0, which means the triangle's own. If the file has none
// at all, they are smooth across seams, triangles come to be wound alike (make_winding_consistent)
// and polygons that are there once more count once. May take the polygons, of the mesh and of the
// triangles, away when they are of no more use.
std::vector<glm::dvec3> vertex_normals(RawMesh& raw, Triangulation& faces);

// The unit vector along v, or zero where v has no direction.
glm::dvec3 unit_or_zero(const glm::dvec3& v);

}  // namespace brume
