#pragma once

#include <cstdint>
#include <vector>

namespace brume {

struct TriangleMesh;

// Surfaces are two-sided; vertex normals point to the front.
enum class MeshSide { front, back };

// The side that is inside a closed part of the mesh, which no light reaches.
enum class Enclosed : std::uint8_t { none, front, back };

inline bool is_enclosed(Enclosed enclosed, MeshSide side) {
  return enclosed == (side == MeshSide::front ? Enclosed::front : Enclosed::back);
}

// Per vertex. Coincident vertices are merged, so seams do not open a part. A part is closed if each
// of its edges is traversed equally often in both directions.
std::vector<Enclosed> enclosed_sides(const TriangleMesh& mesh);

}  // namespace brume
