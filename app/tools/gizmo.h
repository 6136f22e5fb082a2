#pragma once

#include <QPointF>
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/scene/camera.h"

namespace brume {

struct Overlay;

// The handles around a pivot that are dragged to move, rotate or scale; of the same size on the
// film wherever the pivot is.
class Gizmo {
 public:
  enum class Kind { move, rotate, scale };
  // What is grabbed: an axis, or the middle, which stands for all of them (moving across the view,
  // turning around the view, scaling alike).
  enum class Part { x, y, z, all };

  Gizmo(Kind kind, const glm::dvec3& pivot, const CameraRays& rays);

  [[nodiscard]] std::optional<Part> pick(QPointF position) const;
  void draw(Overlay& overlay, std::optional<Part> active) const;

 private:
  struct Shape {
    Part part;
    std::vector<QPointF> line;  // on the film
    bool has_mark = false;      // at its end
  };
  void add_axis(Part part, const CameraRays& rays, const glm::dvec3& pivot, double length);
  void add_ring(Part part, const CameraRays& rays, const glm::dvec3& pivot, const glm::dvec3& axis,
                double radius);

  std::vector<Shape> shapes_;
};

// How far a drag of the mouse between two film positions goes.
// Along an axis through the pivot [u]; 0 where the axis points at the eye.
double dragged_along(const glm::dvec3& pivot, const glm::dvec3& axis, const CameraRays& rays,
                     QPointF from, QPointF to);
// In the plane across the view through the pivot [u].
glm::dvec3 dragged_across(const glm::dvec3& pivot, const CameraRays& rays, QPointF from,
                          QPointF to);
// Around an axis through the pivot [radians, right-handed].
double dragged_around(const glm::dvec3& pivot, const glm::dvec3& axis, const CameraRays& rays,
                      QPointF from, QPointF to);
// Away from the pivot, as the factor by which the distance on the film grows; > 0.
double dragged_away(const glm::dvec3& pivot, const CameraRays& rays, QPointF from, QPointF to);

glm::dvec3 axis_of(Gizmo::Part part);  // x, y or z

}  // namespace brume
