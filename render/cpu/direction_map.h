#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace brume {

// A ball that a map is to show.
struct Ball {
  glm::dvec3 center{0.0};
  double radius = 0.0;
};

// A map of directions around a point onto [-1, 1]^2: perspective through a window that just holds
// what is to be seen, or octahedral (all directions) where that spans too wide an angle. Tables
// over it have columns x rows cells and a border of one cell on all sides for linear interpolation.
struct DirectionMap {
  int columns = 0;
  int rows = 0;
  bool octahedral = true;
  // Of the perspective map: a direction q stands at scale * (q.right, q.up) / q.axis + offset.
  glm::vec3 right{1, 0, 0}, up{0, 1, 0}, axis{0, 0, 1};
  glm::vec2 scale{1.0f};
  glm::vec2 offset{0.0f};

  // All directions; `size` columns and rows.
  static DirectionMap all(int size);

  // The directions that meet any of the balls (those of radius <= 0 do not count), with about
  // size * size cells, nearly square.
  static DirectionMap towards(const glm::dvec3& origin, std::span<const Ball> balls, int size);

  // Whether all directions that meet a ball are on the map.
  [[nodiscard]] bool shows(const glm::dvec3& origin, const Ball& ball) const;

  // The same directions with about size * size cells.
  [[nodiscard]] DirectionMap resized(int size) const;

  // Cells of one row and of all rows, the border included.
  [[nodiscard]] int stride() const { return columns + 2; }
  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(stride()) * static_cast<std::size_t>(rows + 2);
  }

  // The unit direction of the middle of a cell; -1, `columns` and `rows` are the border.
  [[nodiscard]] glm::dvec3 direction(int x, int y) const;

  // The greatest angle between neighbouring cells [radians], about.
  [[nodiscard]] double cell_angle() const;

  bool operator==(const DirectionMap&) const = default;
};

}  // namespace brume
