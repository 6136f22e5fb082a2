#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "brume/export.h"

namespace brume {

struct Surface;
struct TriangleMesh;

// A mesh as flat arrays, in its file's own coordinates.
struct MeshArrays {
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> normals;  // unit, or 0: the triangle's own; as many as points
  std::vector<glm::uvec3> triangles;
  std::vector<glm::vec2> texcoords{};  // u to the right, v up; as many as points, or none
  // The coordinates of textures that name the second set; none without the first.
  std::vector<glm::vec2> second_texcoords{};
  // Linear RGBA in [0, 1], as many as points, or none. On metallic-roughness materials RGB
  // multiplies base color and transmission, A opacity.
  std::vector<glm::vec4> colors{};

  bool operator==(const MeshArrays&) const = default;
};

BRUME_EXPORT const MeshArrays& to_arrays(const TriangleMesh& mesh);

// Throws DomainError. Null: the mesh needs more than `max_bytes`.
BRUME_EXPORT std::shared_ptr<TriangleMesh> to_mesh(
    MeshArrays arrays, std::size_t max_bytes = std::numeric_limits<std::size_t>::max());

// Memory of a mesh.
BRUME_EXPORT std::size_t mesh_bytes(const TriangleMesh& mesh);

// The box around a mesh, in its file's own coordinates; of no vertices around the origin.
struct MeshBox {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};
};
BRUME_EXPORT MeshBox box_of(const TriangleMesh& mesh);

// The points of a surface's mesh in the world.
BRUME_EXPORT std::vector<glm::dvec3> world_points(const Surface& surface,
                                                  std::span<const glm::vec3> points);
BRUME_EXPORT std::vector<glm::dvec3> world_points(const Surface& surface);

// The box around a surface and its copies in the world; low > high if it has no vertices.
BRUME_EXPORT MeshBox world_box(const Surface& surface);

}  // namespace brume
