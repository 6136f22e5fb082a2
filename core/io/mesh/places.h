#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/io/mesh/mesh_readers.h"
#include "core/io/mesh/triangulate.h"

namespace brume {

// The first point at the place of each; -0 is 0.
std::vector<std::uint32_t> find_places(std::span<const glm::dvec3> points);

// Polygons that are in a mesh once more, at the same places, turned round or not.
struct PolygonCopies {
  std::vector<std::uint32_t> originals;  // of each polygon the first one there, or itself
  std::vector<bool> is_turned;           // of each polygon, against that
  // A vertex of a copy, and that of the original at its place, where they are two.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> vertices;

  [[nodiscard]] bool is_copy(std::uint32_t polygon) const { return originals[polygon] != polygon; }
};

// Vertices with the same number in `places` are at one place.
PolygonCopies find_copies(const RawMesh& mesh, std::span<const std::uint32_t> places);

// Cuts copies into the triangles of their originals.
void cut_alike(const RawMesh& mesh, std::span<const std::uint32_t> places,
               const PolygonCopies& copies, Triangulation& faces);

}  // namespace brume
