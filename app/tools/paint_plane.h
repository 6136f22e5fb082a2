#pragma once

#include <QPointF>
#include <glm/vec3.hpp>
#include <optional>

#include "core/scene/camera_rays.h"

namespace brume {

class SurfacePicker;
struct Overlay;

// Where a brush paints: the view plane through a pivot, an axis-aligned plane (ground: y, walls: x
// and z), or the scene's surfaces.
enum class PaintPlane { view, ground, wall_x, wall_z, surface };

// Moves what is painted: onto the surface under the mouse if there is one, or to the nearest point
// of a grid through the origin.
enum class Snap { none, surface, grid };

struct PaintTarget {
  PaintPlane plane = PaintPlane::view;
  double position = 0.0;  // of axis-aligned planes [u]
  Snap snap = Snap::none;
  double grid = 0.5;  // distance between points of the grid, > 0 [u]

  [[nodiscard]] bool has_position() const {
    return plane != PaintPlane::view && plane != PaintPlane::surface;
  }
};

struct PaintPoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  // unit
};

// nullopt if the position misses the plane or surfaces, unless it snaps.
std::optional<PaintPoint> paint_point(const PaintTarget& target, const glm::dvec3& pivot,
                                      const CameraRays& rays, QPointF position,
                                      SurfacePicker& surfaces);

// Brush cursor: outline of its sphere, and faintly the paint plane.
void add_brush_cursor(Overlay& overlay, const CameraRays& rays, const PaintPoint& point,
                      double radius);

}  // namespace brume
