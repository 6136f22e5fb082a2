#include "core/io/import/node_transform.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "brume/error.h"
#include "core/number_domain.h"
#include "core/scene/lights/area_normal.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

// The cofactors: the inverse transpose up to its length and sign, for singular matrices too.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0.0 ? -cofactors : cofactors;
}

// The unit vector along v, or 0 where it has no direction.
glm::dvec3 direction_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 && length <= 1e150 ? v / length : glm::dvec3(0.0);
}

// Vertices whose normal is 0 get that of their triangles, if those have one in all.
void complete_normals(MeshArrays& mesh) {
  std::vector<glm::dvec3> sums(mesh.points.size(), glm::dvec3(0.0));
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) sums[triangle[k]] += area_normal(mesh.points, triangle);
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (mesh.normals[i] == glm::vec3(0.0f)) mesh.normals[i] = direction_or_zero(sums[i]);
  }
}

}  // namespace

void apply_transform(const glm::dmat4& to_world, const std::filesystem::path& file,
                     const std::string& place, MeshArrays& mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const glm::dvec3 point(to_world * glm::dvec4(mesh.points[i], 1.0));
    for (int axis = 0; axis < 3; ++axis) {
      if (domain::coordinate.contains(point[axis])) continue;
      throw InputError(
          file, place,
          "vertex " + std::to_string(i) + ": " + domain::coordinate.refusal(point[axis]));
    }
    mesh.points[i] = point;
  }
  const glm::dmat3 matrix(to_world);
  for (glm::vec3& normal : mesh.normals) normal = moved_normal(matrix, normal);
  if (glm::determinant(matrix) < 0.0) {
    for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
  }
  complete_normals(mesh);
}

glm::dvec3 moved_normal(const glm::dmat3& to_world, const glm::dvec3& normal) {
  return direction_or_zero(normal_matrix(to_world) * direction_or_zero(normal));
}

void add_flat_normals(MeshArrays& mesh) {
  // Each triangle has vertices of its own.
  const auto split = [&triangles = mesh.triangles](auto& values, auto&&...) {
    if (values.empty()) return;
    auto shared = std::exchange(values, {});
    values.reserve(3 * triangles.size());
    for (const glm::uvec3& triangle : triangles) {
      for (int k = 0; k < 3; ++k) values.push_back(shared[triangle[k]]);
    }
  };
  std::vector<glm::vec3> normals;
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::vec3 normal(direction_or_zero(area_normal(mesh.points, triangle)));
    normals.insert(normals.end(), 3, normal);
  }
  split(mesh.points);
  visit_vertex_values(mesh, split);
  mesh.normals = std::move(normals);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto first = static_cast<unsigned>(3 * i);
    mesh.triangles[i] = {first, first + 1, first + 2};
  }
}

Camera camera_of_node(const glm::dmat4& to_world, const glm::dvec3& pivot, double vertical_fov) {
  Camera camera;
  camera.vertical_fov = vertical_fov;
  camera.eye = to_world[3];
  const glm::dvec3 forward = direction_or_zero(-glm::dvec3(to_world[2]));
  const glm::dvec3 up = direction_or_zero(glm::dvec3(to_world[1]));
  const double distance = glm::dot(pivot - camera.eye, forward);
  camera.target = camera.eye + (distance > 1e-6 ? distance : 1.0) *
                                   (forward == glm::dvec3(0.0) ? glm::dvec3(0, 0, -1) : forward);
  if (up != glm::dvec3(0.0)) camera.up = up;
  return camera;
}

}  // namespace brume
