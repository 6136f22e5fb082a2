#include "brume/mesh_arrays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <string>
#include <utility>

#include "brume/error.h"
#include "core/math/normals.h"
#include "core/scene/mesh.h"
#include "core/scene/placement.h"

namespace brume {
namespace {

void check(const MeshArrays& arrays) {
  const std::size_t count = arrays.points.size();
  if (arrays.normals.size() != count) {
    throw DomainError("normals", "allowed: as many as points");
  }
  visit_vertex_values(arrays, [&](const auto& values, const char* key) {
    if (values.empty() || values.size() == count) return;
    throw DomainError(key, "allowed: as many as points, or none");
  });
  if (arrays.texcoords.empty() && !arrays.second_texcoords.empty()) {
    throw DomainError("second_texcoords", "allowed: with texcoords");
  }
  for (std::size_t i = 0; i < arrays.colors.size(); ++i) {
    const glm::vec4& color = arrays.colors[i];
    if (glm::all(glm::greaterThanEqual(color, glm::vec4(0.0f))) &&
        glm::all(glm::lessThanEqual(color, glm::vec4(1.0f)))) {
      continue;
    }
    throw DomainError("colors[" + std::to_string(i) + "]", "allowed: numbers in [0, 1]");
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
  return mesh_bytes(to_arrays(mesh));
}

std::size_t mesh_bytes(const MeshArrays& arrays) {
  std::size_t bytes =
      std::span(arrays.points).size_bytes() + std::span(arrays.triangles).size_bytes();
  visit_vertex_values(arrays, [&bytes](const auto& values, const char*) {
    bytes += std::span(values).size_bytes();
  });
  return bytes;
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

void complete_normals(MeshArrays& mesh) {
  std::vector<glm::dvec3> sums(mesh.points.size(), glm::dvec3(0.0));
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) sums[triangle[k]] += area_normal(mesh.points, triangle);
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (mesh.normals[i] == glm::vec3(0.0f)) mesh.normals[i] = direction_or_zero(sums[i]);
  }
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

}  // namespace brume
