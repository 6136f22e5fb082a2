#include "brume/mesh_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <string>

#include "brume/error.h"
#include "core/scene/mesh.h"
#include "core/scene/placement.h"

namespace brume {
namespace {

using OpenMesh::Vec3f;
using OpenMesh::VertexHandle;

glm::vec3 to_vec3(const Vec3f& v) {
  return {v[0], v[1], v[2]};
}

// Points, normals, texture coordinates and OpenMesh's connectivity with its status bits.
std::size_t bytes_of(std::size_t vertices, std::size_t edges, std::size_t faces,
                     bool has_texcoords) {
  return (has_texcoords ? 44 : 36) * vertices + 40 * edges + 8 * faces;
}

// OpenMesh reports each triangle that does not fit on its error stream.
class QuietErrors {
 public:
  QuietErrors() : lock_(mutex_) { omerr().disable(); }
  ~QuietErrors() {
    if (was_enabled_) omerr().enable();
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  // OpenMesh has one stream for all threads.
  static inline std::mutex mutex_;
  const std::lock_guard<std::mutex> lock_;
  const bool was_enabled_ = omerr().is_enabled();
};

void check(const MeshArrays& arrays) {
  const std::size_t count = arrays.points.size();
  if (arrays.normals.size() != count ||
      (!arrays.texcoords.empty() && arrays.texcoords.size() != count)) {
    throw DomainError("normals, texcoords", "allowed: as many as points; no texcoords");
  }
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3& p = arrays.points[i];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    throw DomainError("points[" + std::to_string(i) + "]", "allowed: finite numbers");
  }
  for (std::size_t i = 0; i < arrays.triangles.size(); ++i) {
    const glm::uvec3& t = arrays.triangles[i];
    if (std::max({t.x, t.y, t.z}) < count) continue;
    throw DomainError("triangles[" + std::to_string(i) + "]",
                      "found the point " + std::to_string(std::max({t.x, t.y, t.z})) + " of " +
                          std::to_string(count));
  }
}

std::vector<glm::vec3> points_of(const TriangleMesh& mesh) {
  std::vector<glm::vec3> points;
  points.reserve(mesh.n_vertices());
  for (const auto v : mesh.vertices()) points.push_back(to_vec3(mesh.point(v)));
  return points;
}

}  // namespace

MeshArrays to_arrays(const TriangleMesh& mesh) {
  MeshArrays arrays{points_of(mesh), {}, {}, {}};
  arrays.normals.reserve(mesh.n_vertices());
  for (const auto v : mesh.vertices()) arrays.normals.push_back(to_vec3(mesh.normal(v)));
  if (mesh.has_vertex_texcoords2D()) {
    arrays.texcoords.reserve(mesh.n_vertices());
    for (const auto v : mesh.vertices()) {
      const OpenMesh::Vec2f& uv = mesh.texcoord2D(v);
      arrays.texcoords.emplace_back(uv[0], uv[1]);
    }
  }
  arrays.triangles.reserve(mesh.n_faces());
  for (const auto face : mesh.faces()) {
    glm::uvec3& corners = arrays.triangles.emplace_back(0);
    int k = 0;
    for (const auto v : face.vertices()) corners[k++] = static_cast<unsigned>(v.idx());
  }
  return arrays;
}

std::shared_ptr<TriangleMesh> to_mesh(const MeshArrays& arrays, std::size_t max_bytes) {
  check(arrays);
  const std::size_t edges = arrays.triangles.size() * 3 / 2;
  const bool has_texcoords = !arrays.texcoords.empty();
  if (bytes_of(arrays.points.size(), edges, arrays.triangles.size(), has_texcoords) > max_bytes) {
    return nullptr;
  }
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->request_vertex_normals();
  if (has_texcoords) mesh->request_vertex_texcoords2D();
  mesh->reserve(arrays.points.size(), edges, arrays.triangles.size());
  const auto add_vertex = [&](unsigned i) {
    const glm::vec3& p = arrays.points[i];
    const glm::vec3& n = arrays.normals[i];
    const VertexHandle vertex = mesh->add_vertex(Vec3f(p.x, p.y, p.z));
    mesh->set_normal(vertex, Vec3f(n.x, n.y, n.z));
    if (has_texcoords) {
      mesh->set_texcoord2D(vertex, OpenMesh::Vec2f(arrays.texcoords[i].x, arrays.texcoords[i].y));
    }
    return vertex;
  };
  for (unsigned i = 0; i < arrays.points.size(); ++i) add_vertex(i);
  const QuietErrors quiet;
  for (const glm::uvec3& triangle : arrays.triangles) {
    if (mesh_bytes(*mesh) > max_bytes) return nullptr;
    const std::array corners{triangle.x, triangle.y, triangle.z};
    std::array<VertexHandle, 3> vertices;
    std::ranges::transform(corners, vertices.begin(),
                           [](unsigned i) { return VertexHandle(static_cast<int>(i)); });
    if (mesh->add_face(vertices.data(), 3).is_valid()) continue;
    std::ranges::transform(corners, vertices.begin(), add_vertex);
    mesh->add_face(vertices.data(), 3);
  }
  return mesh;
}

std::size_t mesh_bytes(const TriangleMesh& mesh) {
  return bytes_of(mesh.n_vertices(), mesh.n_edges(), mesh.n_faces(), mesh.has_vertex_texcoords2D());
}

MeshBox box_of(const TriangleMesh& mesh) {
  if (mesh.n_vertices() == 0) return {};
  const Vec3f* const points = mesh.points();
  Vec3f low = points[0];
  Vec3f high = points[0];
  for (std::size_t i = 1; i < mesh.n_vertices(); ++i) {
    low.minimize(points[i]);
    high.maximize(points[i]);
  }
  return {glm::dvec3(to_vec3(low)), glm::dvec3(to_vec3(high))};
}

std::vector<glm::dvec3> world_points(const Surface& surface, std::span<const glm::vec3> points) {
  const Placement placement(surface);
  std::vector<glm::dvec3> result(points.size());
  std::ranges::transform(points, result.begin(), [&](const glm::vec3& p) {
    return placement.point_to_world(glm::dvec3(p));
  });
  return result;
}

std::vector<glm::dvec3> world_points(const Surface& surface) {
  return world_points(surface, points_of(*surface.mesh));
}

}  // namespace brume
