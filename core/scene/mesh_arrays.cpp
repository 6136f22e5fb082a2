#include "brume/mesh_arrays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <utility>

#include "brume/error.h"
#include "core/scene/mesh.h"
#include "core/scene/placement.h"

namespace brume {
namespace {

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

}  // namespace

const MeshArrays& to_arrays(const TriangleMesh& mesh) {
  return mesh;
}

std::shared_ptr<TriangleMesh> to_mesh(MeshArrays arrays, std::size_t max_bytes) {
  check(arrays);
  auto mesh = std::make_shared<TriangleMesh>(TriangleMesh{std::move(arrays)});
  return mesh_bytes(*mesh) <= max_bytes ? mesh : nullptr;
}

std::size_t mesh_bytes(const TriangleMesh& mesh) {
  return std::span(mesh.points).size_bytes() + std::span(mesh.normals).size_bytes() +
         std::span(mesh.triangles).size_bytes() + std::span(mesh.texcoords).size_bytes();
}

MeshBox box_of(const TriangleMesh& mesh) {
  if (mesh.points.empty()) return {};
  glm::vec3 low = mesh.points.front();
  glm::vec3 high = low;
  for (const glm::vec3& p : mesh.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {glm::dvec3(low), glm::dvec3(high)};
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
  return world_points(surface, surface.mesh->points);
}

}  // namespace brume
