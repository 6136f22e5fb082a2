#include "core/io/import/node_transform.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "brume/error.h"
#include "core/math/normals.h"
#include "core/number_domain.h"
#include "core/scene/mesh.h"

namespace brume {

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
