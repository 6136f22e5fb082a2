#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/scene.h"
#include "core/scene/materials/ggx.h"

namespace brume {

// A flat side of a smooth surface, which sends light on as from a mirror image.
struct MirrorPlane {
  std::uint32_t surface = 0;  // index
  glm::dvec3 normal{0.0};     // unit
  double offset = 0.0;        // of its points along the normal [u]
  glm::dvec3 low{0.0};        // bounds of its points [u]
  glm::dvec3 high{0.0};
  GgxReflection reflection;  // on average
};

// Surfaces with more sides are curved, or seem so: they have no planes.
inline constexpr std::size_t max_sides = 6;

// The planes of all surfaces that mirror on average (GgxReflection::max_mirror_alpha).
std::vector<MirrorPlane> mirror_planes(std::span<const Surface> surfaces);

}  // namespace brume
