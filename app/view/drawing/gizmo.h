#pragma once

#include <QPointF>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/scene/camera_rays.h"

namespace brume {

struct Overlay;

// Manipulator handles around a pivot to move, rotate or scale, of constant screen size.
class Gizmo {
 public:
  enum class Kind { move, rotate, scale };
  // The grabbed part: an axis, or the center for all (moving in the view plane, rotating about the
  // view axis, uniform scaling).
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
  std::optional<QPointF> middle_;  // all within the middle's ring is it, too
  double middle_radius_ = 0.0;
};

// The effect of a mouse drag between two film positions.
//
// Translation along an axis through the pivot [u]; 0 if it points at the eye.
double dragged_along(const glm::dvec3& pivot, const glm::dvec3& axis, const CameraRays& rays,
                     QPointF start, QPointF end);
// Translation in the view plane through the pivot [u].
glm::dvec3 dragged_across(const glm::dvec3& pivot, const CameraRays& rays, QPointF start,
                          QPointF end);
// Rotation about an axis through the pivot [radians, right-handed].
double dragged_around(const glm::dvec3& pivot, const glm::dvec3& axis, const CameraRays& rays,
                      QPointF start, QPointF end);
// Scale factor: ratio of film distances from the pivot; > 0.
double dragged_away(const glm::dvec3& pivot, const CameraRays& rays, QPointF start, QPointF end);

glm::dvec3 axis_of(Gizmo::Part part);  // x, y or z

}  // namespace brume
