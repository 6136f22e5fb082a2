#include "core/scene/materials/coverage.h"

#include <algorithm>

#include "brume/mesh_arrays.h"

namespace brume {

Coverage::Coverage(const Material& material) {
  if (material.type != Material::Type::metallic_roughness) return;
  const MetallicRoughness& values = material.metallic_roughness;
  alpha = values.alpha;
  if (alpha != AlphaMode::opaque) {
    opacity = values.opacity;
    alpha_texture = values.base_color_texture;
  }
  if (alpha == AlphaMode::cutout) cutoff = values.alpha_cutoff;
  transmission = values.transmission;
  if (transmission != glm::dvec3(0.0)) transmission_texture = values.transmission_texture;
}

double Coverage::opacity_at(const MeshValues& mesh) const {
  return opacity * mesh.color.a * double{lookup(alpha_texture, mesh).a};
}

bool Coverage::is_hole(const MeshValues& mesh) const {
  return has_holes() && opacity_at(mesh) < cutoff;
}

double Coverage::covered(const MeshValues& mesh) const {
  return alpha == AlphaMode::blend ? std::clamp(opacity_at(mesh), 0.0, 1.0) : 1.0;
}

glm::dvec3 Coverage::transmitted(const MeshValues& mesh) const {
  if (transmission == glm::dvec3(0.0)) return glm::dvec3(0.0);
  return transmission * glm::dvec3(mesh.color) * glm::dvec3(lookup(transmission_texture, mesh));
}

bool has_holes(std::span<const Surface> surfaces) {
  return std::ranges::any_of(surfaces,
                             [](const Surface& s) { return Coverage(s.material).has_holes(); });
}

bool has_panes(std::span<const Surface> surfaces) {
  return std::ranges::any_of(surfaces,
                             [](const Surface& s) { return Coverage(s.material).is_pane(); });
}

bool has_colored_panes(std::span<const Surface> surfaces) {
  return std::ranges::any_of(surfaces, [](const Surface& surface) {
    const Coverage coverage(surface.material);
    const glm::dvec3& t = coverage.transmission;
    const bool has_colors = surface.mesh && !to_arrays(*surface.mesh).colors.empty();
    return t.x != t.y || t.y != t.z ||
           (t != glm::dvec3(0.0) && (has_colors || coverage.transmission_texture.content));
  });
}

}  // namespace brume
