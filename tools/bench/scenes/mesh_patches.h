#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "brume/mesh_arrays.h"

namespace brume {

// Meshes put together from patches; see to_mesh().

struct MeshVertex {
  glm::dvec3 position;
  glm::dvec3 normal;
};

// Adds a grid of n x n quads, vertex (i, j) at index first + i (n + 1) + j being
// vertex(i / n, j / n). Returns first.
std::size_t add_patch(MeshArrays& mesh, int n,
                      const std::function<MeshVertex(double, double)>& vertex);

// A square in z = 0 from -half to half, facing +z.
std::size_t add_floor(MeshArrays& mesh, int n, double half);

// The part of a ball up to the polar angle `to` from -z, facing outward or inward.
std::size_t add_ball(MeshArrays& mesh, int n, const glm::dvec3& center, double radius, double to,
                     bool inward);

}  // namespace brume
