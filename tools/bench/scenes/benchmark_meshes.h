#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>

#include "brume/mesh_arrays.h"

namespace brume {

// Meshes of exact vertex counts from simple shapes. Shapes share no vertices, so their edges are
// sharp. Every shape says how many vertices it takes.
class MeshBuilder {
 public:
  using Place = std::function<glm::dvec3(double u, double v)>;

  // columns * rows vertices at place(u, v), u and v from 0 to 1. Closed: the last column joins the
  // first, and u ends one step before 1.
  void grid(int columns, int rows, bool closed, const Place& place);
  // 6 n^2 vertices.
  void box(const glm::dvec3& low, const glm::dvec3& high, int n);
  // 2 n^2 vertices.
  void ellipsoid(const glm::dvec3& center, const glm::dvec3& radii, int n);
  // A straight tube with flat ends: 6 n vertices.
  void cylinder(const glm::dvec3& start, const glm::dvec3& end, double radius, int n);
  // A tube bent along path(v), which is nowhere parallel to z: n * rows vertices.
  void tube(const std::function<glm::dvec3(double v)>& path, double radius, int n, int rows);
  // A grid that is nearly square, padded by vertices within triangles up to exactly `vertices`.
  void sheet(std::size_t vertices, const Place& place);

  [[nodiscard]] std::size_t size() const;
  // With vertex normals.
  std::shared_ptr<const TriangleMesh> finish();

 private:
  MeshArrays mesh_;
};

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
