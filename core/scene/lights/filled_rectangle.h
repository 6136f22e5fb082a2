#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

namespace brume {

// A rectangle in space: `up` is the unit direction of its height [u].
struct FilledRectangle {
  glm::dvec3 center{0.0};
  glm::dvec3 up{0.0};
  double width = 0.0;
  double height = 0.0;
};

// The rectangle, of this unit normal, that triangles fill which lie about in a plane of that normal
// and have this area in all: as large as they are, and as long as the smallest rectangle around
// them. nullopt where that is far from full, or they overlap in it: they then look like none.
std::optional<FilledRectangle> filled_rectangle(
    std::span<const std::array<glm::dvec3, 3>> triangles, double area, const glm::dvec3& normal);

}  // namespace brume
