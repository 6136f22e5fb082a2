#include "tests/render/test_meshes.h"

namespace brume {

std::shared_ptr<TriangleMesh> turned(const TriangleMesh& mesh, const glm::dquat& q) {
  auto result = std::make_shared<TriangleMesh>(mesh);
  for (const auto v : result->vertices()) {
    const MeshVertex old = vertex_of(mesh, static_cast<std::size_t>(v.idx()));
    const glm::vec3 p(q * old.position);
    const glm::vec3 n(q * old.normal);
    result->set_point(v, {p.x, p.y, p.z});
    result->set_normal(v, {n.x, n.y, n.z});
  }
  return result;
}

MeshVertex vertex_of(const TriangleMesh& mesh, std::size_t index) {
  const OpenMesh::VertexHandle v(static_cast<int>(index));
  const auto& p = mesh.point(v);
  const auto& n = mesh.normal(v);
  return {{p[0], p[1], p[2]}, {n[0], n[1], n[2]}};
}

}  // namespace brume
