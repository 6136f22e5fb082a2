#pragma once

#include <QPointF>
#include <glm/vec3.hpp>
#include <optional>

#include "core/scene/camera.h"

namespace brume {

class SurfacePicker;
struct Overlay;

// Where a brush paints: on the plane across the view through a pivot, on one across an axis of the
// world (the ground across y, walls across x and z), or on the surfaces of the scene.
enum class PaintPlane { view, ground, wall_x, wall_z, surface };

struct PaintTarget {
  PaintPlane plane = PaintPlane::view;
  double position = 0.0;  // of ground and walls, along their axis [u]

  [[nodiscard]] bool has_position() const {
    return plane != PaintPlane::view && plane != PaintPlane::surface;
  }
};

struct PaintPoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  // unit, of the plane or the surface there
};

// nullopt where the position looks past the plane or the surfaces.
std::optional<PaintPoint> paint_point(const PaintTarget& target, const glm::dvec3& pivot,
                                      const CameraRays& rays, QPointF position,
                                      SurfacePicker& surfaces);

// The cursor of a brush: the outline of its ball, and faintly the plane it paints on.
void add_brush_cursor(Overlay& overlay, const CameraRays& rays, const PaintPoint& point,
                      double radius);

}  // namespace brume
