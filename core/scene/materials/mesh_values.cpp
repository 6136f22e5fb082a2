#include "core/scene/materials/mesh_values.h"

#include <glm/geometric.hpp>

#include "core/scene/materials/texture.h"

namespace brume {

MeshValues interpolate(const std::array<MeshValues, 3>& corners, const glm::dvec3& weights) {
  MeshValues result;
  result.color = glm::dvec4(0.0);
  for (int k = 0; k < 3; ++k) {
    const MeshValues& corner = corners[static_cast<std::size_t>(k)];
    for (std::size_t set = 0; set < result.texcoords.size(); ++set) {
      result.texcoords[set].uv += weights[k] * corner.texcoords[set].uv;
    }
    result.color += weights[k] * corner.color;
  }
  return result;
}

std::array<MeshValues, 3> corner_values(const MeshArrays& mesh, std::size_t triangle) {
  std::array<MeshValues, 3> corners;
  const auto& second = mesh.second_texcoords.empty() ? mesh.texcoords : mesh.second_texcoords;
  for (int k = 0; k < 3; ++k) {
    const unsigned vertex = mesh.triangles[triangle][k];
    MeshValues& corner = corners[static_cast<std::size_t>(k)];
    if (!mesh.texcoords.empty()) {
      corner.texcoords[0].uv = glm::dvec2(mesh.texcoords[vertex]);
      corner.texcoords[1].uv = glm::dvec2(second[vertex]);
    }
    if (!mesh.colors.empty()) corner.color = glm::dvec4(mesh.colors[vertex]);
  }
  return corners;
}

MeshValues values_in(const MeshArrays& mesh, std::size_t triangle, const glm::dvec3& weights) {
  if (mesh.texcoords.empty() && mesh.colors.empty()) return {};
  return interpolate(corner_values(mesh, triangle), weights);
}

glm::dvec4 mean_color(const MeshArrays& mesh) {
  if (mesh.colors.empty()) return glm::dvec4(1.0);
  glm::dvec4 sum(0.0);
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::uvec3& corners = mesh.triangles[t];
    const glm::dvec3 first(mesh.points[corners.x]);
    const double size = glm::length(glm::cross(glm::dvec3(mesh.points[corners.y]) - first,
                                               glm::dvec3(mesh.points[corners.z]) - first));
    sum += size * values_in(mesh, t, glm::dvec3(1.0 / 3.0)).color;
    area += size;
  }
  return area > 0.0 ? sum / area : glm::dvec4(1.0);
}

glm::vec4 lookup(const TextureReference& texture, const MeshValues& values) {
  if (!texture.content) return glm::vec4(1.0f);
  const auto& [uv, footprint] = values.texcoords[texture.uses_second_texcoords ? 1 : 0];
  return texture.content->lookup(uv, footprint, texture.wrap_u, texture.wrap_v);
}

}  // namespace brume
