#include "tests/render/test_meshes.h"

namespace brume {

std::shared_ptr<TriangleMesh> turned(const TriangleMesh& mesh, const glm::dquat& q) {
  MeshArrays arrays = to_arrays(mesh);
  for (glm::vec3& p : arrays.points) p = glm::vec3(q * glm::dvec3(p));
  for (glm::vec3& n : arrays.normals) n = glm::vec3(q * glm::dvec3(n));
  return to_mesh(arrays);
}

}  // namespace brume
