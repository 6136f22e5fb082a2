#pragma once

#include <QPointF>
#include <glm/vec3.hpp>
#include <optional>

namespace brume {

class CameraRays;
class View;

// The place that a tool paints on: what is under the mouse, the view plane through a pivot, an
// axis-aligned plane (ground: y, walls: x and z), or only the scene's surfaces.
enum class PaintPlane { under_mouse, view, ground, wall_x, wall_z, surface };

struct PaintTarget {
  PaintPlane plane = PaintPlane::under_mouse;
  double position = 0.0;       // of axis-aligned planes [u]
  bool snaps_to_grid = false;  // to the nearest point of a grid through the origin
  double grid = 0.5;           // distance between its points, > 0 [u]
  bool stands = false;         // all of the ball is above surfaces, however much nearer it comes

  [[nodiscard]] bool has_position() const {
    return plane == PaintPlane::ground || plane == PaintPlane::wall_x ||
           plane == PaintPlane::wall_z;
  }
};

struct PaintPoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};     // unit
  double distance = 0.0;      // along the ray to what is under the mouse there [u]
  bool on_surface = false;    // rather than in the air
  glm::dvec3 unsnapped{0.0};  // the position but for the grid
};

// The points of a stroke that the depth of its next one follows from.
struct StrokeDepth {
  explicit StrokeDepth(const PaintPoint& begin)
      : first(begin), last(begin), farthest(begin.distance) {}
  void extend(const PaintPoint& point);

  PaintPoint first;
  PaintPoint last;
  double farthest;  // distance of its points [u]
};

// Whether neighbouring points of a stroke of balls are not on one thing: they are more than an
// eighth of their depth apart, and do not overlap.
bool is_depth_jump(const CameraRays& rays, const PaintPoint& last, const PaintPoint& next,
                   double radius);

// The place of a tool's point for a position of the mouse; nullopt if that misses the plane, or the
// surfaces if these alone are painted on.
//
// PaintPlane::under_mouse: a ball of `radius` [u] in front of the surface, which it touches unless
// it would come much nearer, at a flat angle; without a surface the depth up to which the Gaussians
// take half of the light that they take at all; without Gaussians the view plane. It is never
// farther than fog lets half of the light through, so that what is painted is seen.
//
// The points of a stroke that began on a surface stay on surfaces, and keep the last depth where
// there is none, or one half as far again as any before; those of one that began in the air keep
// its depth, but stay in front of surfaces.
std::optional<PaintPoint> paint_point(View& view, const PaintTarget& target, QPointF position,
                                      double radius,
                                      const std::optional<StrokeDepth>& stroke = std::nullopt);

}  // namespace brume
