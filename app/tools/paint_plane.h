#pragma once

#include <QPointF>
#include <glm/vec3.hpp>
#include <optional>

#include "core/scene/camera.h"

namespace brume {

class SurfacePicker;
struct Overlay;

// Where a brush paints: on the plane across the view through a pivot, on the ground (y = 0), or on
// the surfaces of the scene.
enum class PaintPlane { view, ground, surface };

struct PaintPoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  // unit, of the plane or the surface there
};

// nullopt where the position looks past the plane or the surfaces.
std::optional<PaintPoint> paint_point(PaintPlane plane, const glm::dvec3& pivot,
                                      const CameraRays& rays, QPointF position,
                                      SurfacePicker& surfaces);

// The cursor of a brush: the outline of its ball, and faintly the plane it paints on.
void add_brush_cursor(Overlay& overlay, const CameraRays& rays, const PaintPoint& point,
                      double radius);

}  // namespace brume
