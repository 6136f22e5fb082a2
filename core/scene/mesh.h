#pragma once

#include <cstddef>

#include "brume/mesh_arrays.h"

namespace brume {

// A mesh that surfaces share; never changed.
struct TriangleMesh : MeshArrays {
  [[nodiscard]] std::size_t n_vertices() const { return points.size(); }
  [[nodiscard]] std::size_t n_faces() const { return triangles.size(); }
};

}  // namespace brume
