#include "core/scene/materials/coverage.h"

#include <algorithm>

#include "core/scene/materials/texture.h"

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

bool Coverage::is_hole(const glm::dvec2& uv) const {
  return has_holes() && opacity * double{lookup(alpha_texture, uv, 0.0).a} < cutoff;
}

double Coverage::covered(const glm::dvec2& uv, double footprint) const {
  if (alpha != AlphaMode::blend) return 1.0;
  return std::clamp(opacity * double{lookup(alpha_texture, uv, footprint).a}, 0.0, 1.0);
}

glm::dvec3 Coverage::transmitted(const glm::dvec2& uv, double footprint) const {
  if (transmission == glm::dvec3(0.0)) return glm::dvec3(0.0);
  return transmission * glm::dvec3(lookup(transmission_texture, uv, footprint));
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
    return t.x != t.y || t.y != t.z || coverage.transmission_texture.content;
  });
}

}  // namespace brume
