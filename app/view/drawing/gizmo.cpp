#include "app/view/drawing/gizmo.h"
#include "core/scene/camera_rays.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "app/view/drawing/overlay.h"
#include "app/widgets/interface_settings.h"
#include "core/math/basis.h"

namespace brume {
namespace {

constexpr double size_on_film = 80.0;  // pixels
constexpr double pick_distance = 7.0;

QRgb color_of(Gizmo::Part part, bool active) {
  if (active) return qRgba(255, 235, 120, 255);
  switch (part) {
    case Gizmo::Part::x:
      return qRgba(226, 92, 92, 235);
    case Gizmo::Part::y:
      return qRgba(126, 196, 92, 235);
    case Gizmo::Part::z:
      return qRgba(96, 146, 236, 235);
    default:
      return qRgba(235, 238, 242, 220);
  }
}

QPointF on_film(const CameraRays& rays, const glm::dvec3& point) {
  const glm::dvec3 p = rays.project(point);
  return {p.x, p.y};
}

double distance_to_segment(QPointF point, QPointF start, QPointF end) {
  const QPointF way = end - start;
  const double square = QPointF::dotProduct(way, way);
  const double t =
      square > 0.0 ? std::clamp(QPointF::dotProduct(point - start, way) / square, 0.0, 1.0) : 0.0;
  return QLineF(point, start + t * way).length();
}

// The length at the pivot that is one pixel on the film [u].
double pixel_at(const glm::dvec3& pivot, const CameraRays& rays) {
  const double depth = glm::dot(pivot - rays.eye(), rays.forward());
  return depth * std::tan(2.0 * rays.pixel_half_angle()) + rays.pixel_width();
}

}  // namespace

glm::dvec3 axis_of(Gizmo::Part part) {
  glm::dvec3 axis(0.0);
  if (part != Gizmo::Part::all) axis[static_cast<int>(part)] = 1.0;
  return axis;
}

Gizmo::Gizmo(Kind kind, const glm::dvec3& pivot, const CameraRays& rays) {
  if (rays.project(pivot).z <= 0.0) return;  // behind the eye
  const double size = size_on_film * handle_scale() * pixel_at(pivot, rays);
  for (const Part part : {Part::x, Part::y, Part::z}) {
    if (kind == Kind::rotate) {
      add_ring(part, rays, pivot, axis_of(part), size);
    } else {
      add_axis(part, rays, pivot, size);
    }
  }
  constexpr double middle = 0.12;
  add_ring(Part::all, rays, pivot, -rays.forward(), (kind == Kind::rotate ? 1.2 : middle) * size);
  if (kind == Kind::move) {
    middle_ = on_film(rays, pivot);
    middle_radius_ = middle * size_on_film * handle_scale();
  }
}

void Gizmo::add_axis(Part part, const CameraRays& rays, const glm::dvec3& pivot, double length) {
  const glm::dvec3 axis = axis_of(part);
  const glm::dvec3 end = pivot + length * axis;
  if (rays.project(end).z <= 0.0) return;
  // It begins outside the middle's ring, which would be hard to grab otherwise.
  shapes_.push_back({part, {on_film(rays, pivot + 0.2 * length * axis), on_film(rays, end)}, true});
}

void Gizmo::add_ring(Part part, const CameraRays& rays, const glm::dvec3& pivot,
                     const glm::dvec3& axis, double radius) {
  const auto [u, v] = make_basis(axis);
  Shape ring{part, {}, false};
  constexpr int segments = 48;
  for (int k = 0; k <= segments; ++k) {
    const double angle = glm::two_pi<double>() * k / segments;
    const glm::dvec3 point = pivot + radius * (std::cos(angle) * u + std::sin(angle) * v);
    if (rays.project(point).z <= 0.0) return;
    ring.line.push_back(on_film(rays, point));
  }
  shapes_.push_back(std::move(ring));
}

std::optional<Gizmo::Part> Gizmo::pick(QPointF position) const {
  if (middle_ && QLineF(position, *middle_).length() <= middle_radius_) return Part::all;
  std::optional<Part> best;
  double nearest = pick_distance * handle_scale();
  for (const Shape& shape : shapes_) {
    for (std::size_t k = 0; k + 1 < shape.line.size(); ++k) {
      const double distance = distance_to_segment(position, shape.line[k], shape.line[k + 1]);
      if (distance > nearest) continue;
      nearest = distance;
      best = shape.part;
    }
  }
  return best;
}

void Gizmo::draw(Overlay& overlay, std::optional<Part> active) const {
  for (const Shape& shape : shapes_) {
    const QRgb color = color_of(shape.part, shape.part == active);
    const auto vertex = [&](std::size_t k) {
      return Overlay::Vertex{static_cast<float>(shape.line[k].x()),
                             static_cast<float>(shape.line[k].y()), color};
    };
    for (std::size_t k = 0; k + 1 < shape.line.size(); ++k) {
      overlay.lines.push_back(vertex(k));
      overlay.lines.push_back(vertex(k + 1));
    }
    if (shape.has_mark) overlay.marks.push_back(vertex(shape.line.size() - 1));
  }
}

double dragged_along(const glm::dvec3& pivot, const glm::dvec3& axis, const CameraRays& rays,
                     QPointF start, QPointF end) {
  // Where the axis comes nearest to the ray through a position.
  const auto nearest = [&](QPointF position) {
    const glm::dvec3 d = rays.direction(position.x(), position.y());
    const glm::dvec3 gap = pivot - rays.origin(position.x(), position.y());
    const double b = glm::dot(axis, d);
    return (b * glm::dot(gap, d) - glm::dot(gap, axis)) / (1.0 - b * b);
  };
  const double distance = nearest(end) - nearest(start);
  return std::isfinite(distance) ? distance : 0.0;
}

glm::dvec3 dragged_across(const glm::dvec3& pivot, const CameraRays& rays, QPointF start,
                          QPointF end) {
  const double depth = glm::dot(pivot - rays.eye(), rays.forward());
  const auto on_plane = [&](QPointF position) {
    const glm::dvec3 d = rays.direction(position.x(), position.y());
    return rays.offset(position.x(), position.y()) + d * (depth / glm::dot(d, rays.forward()));
  };
  return on_plane(end) - on_plane(start);
}

double dragged_around(const glm::dvec3& pivot, const glm::dvec3& axis, const CameraRays& rays,
                      QPointF start, QPointF end) {
  const QPointF center = on_film(rays, pivot);
  const QPointF a = start - center;
  const QPointF b = end - center;
  // y points down on the film, so this is positive clockwise, as an axis is that points away.
  const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), QPointF::dotProduct(a, b));
  return glm::dot(axis, rays.towards(pivot)) > 0.0 ? angle : -angle;
}

double dragged_away(const glm::dvec3& pivot, const CameraRays& rays, QPointF start, QPointF end) {
  const QPointF center = on_film(rays, pivot);
  return std::max(QLineF(center, end).length(), 1.0) /
         std::max(QLineF(center, start).length(), 1.0);
}

}  // namespace brume
