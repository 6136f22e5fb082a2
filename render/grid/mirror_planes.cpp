#include "render/grid/mirror_planes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"

namespace brume {
namespace {

// The sides of a surface; empty: it has more than max_sides.
std::vector<MirrorPlane> sides_of(const Surface& surface) {
  const MeshArrays& mesh = to_arrays(*surface.mesh);
  const std::vector<glm::dvec3> points = world_points(surface, mesh.points);
  std::vector<MirrorPlane> sides;
  for (const glm::uvec3& corners : mesh.triangles) {
    const glm::dvec3& a = points[corners.x];
    const glm::dvec3 across = glm::cross(points[corners.y] - a, points[corners.z] - a);
    const double area = glm::length(across);
    if (!(area > 0.0)) continue;
    const glm::dvec3 normal = across / area;
    const double offset = glm::dot(normal, a);
    constexpr double rounding = 1e-4;
    const auto is_of = [&](const MirrorPlane& side) {
      return glm::dot(side.normal, normal) > 1.0 - rounding * rounding &&
             std::abs(side.offset - offset) < rounding * (std::sqrt(area) + std::abs(offset));
    };
    auto side = std::ranges::find_if(sides, is_of);
    if (side == sides.end()) {
      if (sides.size() == max_sides) return {};
      sides.push_back({.normal = normal, .offset = offset, .low = a, .high = a, .reflection = {}});
      side = sides.end() - 1;
    }
    for (int k = 0; k < 3; ++k) {
      side->low = glm::min(side->low, points[corners[k]]);
      side->high = glm::max(side->high, points[corners[k]]);
    }
  }
  return sides;
}

}  // namespace

std::vector<MirrorPlane> mirror_planes(std::span<const Surface> surfaces) {
  std::vector<MirrorPlane> planes;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const Material& material = surfaces[s].material;
    if (material.type != Material::Type::metallic_roughness) continue;
    if (!may_mirror(material.metallic_roughness)) continue;
    const glm::dvec4 color = mean_color(to_arrays(*surfaces[s].mesh));
    const GgxReflection reflection =
        average_material(material.metallic_roughness, color).reflection;
    if (!(reflection.alpha < GgxReflection::max_mirror_alpha)) continue;
    for (MirrorPlane& side : sides_of(surfaces[s])) {
      side.surface = static_cast<std::uint32_t>(s);
      side.reflection = reflection;
      planes.push_back(side);
    }
  }
  return planes;
}

}  // namespace brume
