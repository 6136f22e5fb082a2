#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "brume/mesh_arrays.h"

namespace brume {

// The neighbours of triangles and vertices in a mesh, by OpenMesh's half-edges. Triangles that do
// not fit a manifold are no neighbours of the others at their edges, which are borders.
class MeshTopology {
 public:
  explicit MeshTopology(const MeshArrays& mesh);
  ~MeshTopology();
  MeshTopology(const MeshTopology&) = delete;
  MeshTopology& operator=(const MeshTopology&) = delete;

  // The triangles around a vertex, in their order.
  [[nodiscard]] std::vector<std::uint32_t> triangles_at(std::size_t vertex) const;
  // Whether an edge at a vertex is that of one triangle only.
  [[nodiscard]] bool is_on_border(std::size_t vertex) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace brume
