#pragma once

#include <cstdint>
#include <vector>

namespace brume {

struct TriangleMesh;

// Surfaces are lit on both sides; the front is the one that vertex normals point to.
enum class MeshSide { front, back };

// Which side of a surface no light from outside can reach because it is the inside of a closed
// part of the mesh.
enum class Enclosed : std::uint8_t { none, front, back };

inline bool is_enclosed(Enclosed enclosed, MeshSide side) {
  return enclosed == (side == MeshSide::front ? Enclosed::front : Enclosed::back);
}

// For each vertex. Vertices at the same place count as one, so that seams do not open a part. A
// part is closed if each of its edges is passed as often one way as the other.
std::vector<Enclosed> enclosed_sides(const TriangleMesh& mesh);

}  // namespace brume
