#pragma once

#include <cstddef>

#include "brume/mesh_arrays.h"

namespace brume {

// A mesh that surfaces share; never changed.
struct TriangleMesh : MeshArrays {
  [[nodiscard]] std::size_t n_vertices() const { return points.size(); }
  [[nodiscard]] std::size_t n_faces() const { return triangles.size(); }
};

// Calls visit(list, key) for what a mesh has of each vertex besides its place; lists are empty
// where it has none.
void visit_vertex_values(auto& arrays, auto&& visit) {
  visit(arrays.normals, "normals");
  visit(arrays.texcoords, "texcoords");
  visit(arrays.second_texcoords, "second_texcoords");
  visit(arrays.colors, "colors");
}

// A mesh without normals gets those of its triangles, which then share no vertices.
void add_flat_normals(MeshArrays& mesh);
// Vertices whose normal is 0 get that of their triangles, if those have one in all.
void complete_normals(MeshArrays& mesh);

// Memory of a mesh.
std::size_t mesh_bytes(const MeshArrays& arrays);

}  // namespace brume
