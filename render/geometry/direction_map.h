#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace brume {

// A ball that a map must cover.
struct Ball {
  glm::dvec3 center{0.0};
  double radius = 0.0;
};

// A map of directions around a point onto [-1, 1]^2: perspective if a window holds all targets,
// octahedral (all directions) if they span too wide an angle. Tables over it have columns x rows
// cells plus a border of one cell for bilinear interpolation.
struct DirectionMap {
  int columns = 0;
  int rows = 0;
  bool octahedral = true;
  // Perspective map: position = scale * (q.right, q.up) / q.axis + offset.
  glm::vec3 right{1, 0, 0}, up{0, 1, 0}, axis{0, 0, 1};
  glm::vec2 scale{1.0f};
  glm::vec2 offset{0.0f};

  // The full sphere, octahedral; `size` columns and rows.
  static DirectionMap full_sphere(int size);

  // Covers the balls (those of radius <= 0 are ignored) with about size * size nearly square cells.
  static DirectionMap towards(const glm::dvec3& origin, std::span<const Ball> balls, int size);

  // The same directions at another resolution.
  [[nodiscard]] DirectionMap resized(int size) const;

  // Cells of one row and of all rows, including the border.
  [[nodiscard]] int stride() const { return columns + 2; }
  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(stride()) * static_cast<std::size_t>(rows + 2);
  }

  // Unit direction of the center of a cell; -1, `columns` and `rows` are the border.
  [[nodiscard]] glm::dvec3 direction(int x, int y) const;

  // Components of `q` along right, up and axis, in double precision.
  [[nodiscard]] glm::dvec3 components(const glm::dvec3& q) const;

  // Approximate maximum angle between neighbouring cells [radians].
  [[nodiscard]] double cell_angle() const;

  // Below this cosine to the axis of a perspective map, lookups are clamped to its border.
  static constexpr float min_cosine = 1e-3f;
  // Look-ups end this far beyond the center of the last cell, short of the border's.
  static constexpr float border_share = 0.999f;

  bool operator==(const DirectionMap&) const = default;
};

}  // namespace brume
