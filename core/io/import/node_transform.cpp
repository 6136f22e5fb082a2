#include "core/io/import/node_transform.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "brume/error.h"
#include "core/number_domain.h"

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

glm::dvec3 area_normal(const MeshArrays& mesh, const glm::uvec3& triangle) {
  const glm::dvec3 a(mesh.points[triangle.x]);
  return glm::cross(glm::dvec3(mesh.points[triangle.y]) - a,
                    glm::dvec3(mesh.points[triangle.z]) - a);
}

// Vertices whose normal is 0 get that of their triangles, or else +y.
void complete_normals(MeshArrays& mesh) {
  std::vector<glm::dvec3> sums(mesh.points.size(), glm::dvec3(0.0));
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) sums[triangle[k]] += area_normal(mesh, triangle);
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (mesh.normals[i] != glm::vec3(0.0f)) continue;
    const glm::dvec3 normal = direction_or_zero(sums[i]);
    mesh.normals[i] = normal == glm::dvec3(0.0) ? glm::dvec3(0.0, 1.0, 0.0) : normal;
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
  const glm::dmat3 of_normals = normal_matrix(matrix);
  for (glm::vec3& normal : mesh.normals) {
    normal = direction_or_zero(of_normals * direction_or_zero(glm::dvec3(normal)));
  }
  if (glm::determinant(matrix) < 0.0) {
    for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
  }
  complete_normals(mesh);
}

void add_flat_normals(MeshArrays& mesh) {
  MeshArrays flat;
  for (const glm::uvec3& triangle : mesh.triangles) {
    const auto first = static_cast<unsigned>(flat.points.size());
    const glm::vec3 normal(direction_or_zero(area_normal(mesh, triangle)));
    for (int k = 0; k < 3; ++k) {
      flat.points.push_back(mesh.points[triangle[k]]);
      flat.normals.push_back(normal);
      if (!mesh.texcoords.empty()) flat.texcoords.push_back(mesh.texcoords[triangle[k]]);
    }
    flat.triangles.emplace_back(first, first + 1, first + 2);
  }
  mesh = std::move(flat);
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
