#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "brume/scene.h"
#include "core/scene/materials/mesh_values.h"

namespace brume {

// How much of a surface is there, of a metallic-roughness material: holes (`cutout`), and panes,
// which let light through unbent (`blend`, transmission).
struct Coverage {
  AlphaMode alpha = AlphaMode::opaque;
  double opacity = 1.0;
  double cutoff = 0.5;
  glm::dvec3 transmission{0.0};
  TextureReference alpha_texture{};
  TextureReference transmission_texture{};

  Coverage() = default;
  explicit Coverage(const Material& material);

  [[nodiscard]] bool has_holes() const { return alpha == AlphaMode::cutout; }
  [[nodiscard]] bool is_pane() const {
    return alpha == AlphaMode::blend || transmission != glm::dvec3(0.0);
  }
  [[nodiscard]] bool is_opaque() const { return !has_holes() && !is_pane(); }

  // Whether a point of the mesh, without footprints, is none of the surface.
  [[nodiscard]] bool is_hole(const MeshValues& mesh) const;
  // The share that a pane covers; 1 where it has no holes.
  [[nodiscard]] double covered(const MeshValues& mesh) const;
  // The share of the light on what is covered that crosses it, per channel.
  [[nodiscard]] glm::dvec3 transmitted(const MeshValues& mesh) const;

  bool operator==(const Coverage&) const = default;

 private:
  [[nodiscard]] double opacity_at(const MeshValues& mesh) const;
};

bool has_holes(std::span<const Surface> surfaces);
bool has_panes(std::span<const Surface> surfaces);
// Whether panes may let through more of one channel than of another.
bool has_colored_panes(std::span<const Surface> surfaces);

}  // namespace brume
