#include "app/tools/paint_plane.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/view/overlay.h"
#include "app/view/surface_picker.h"
#include "app/widgets/application.h"
#include "core/math/basis.h"
#include "core/scene/camera_rays.h"

namespace brume {
namespace {

// A ray through the film.
struct FilmRay {
  glm::dvec3 origin, direction;
};

std::optional<PaintPoint> on_plane(const glm::dvec3& through, const glm::dvec3& normal,
                                   const FilmRay& ray) {
  const double across = glm::dot(ray.direction, normal);
  const double t = glm::dot(through - ray.origin, normal) / across;
  if (!(t > 0.0) || !std::isfinite(t)) return std::nullopt;
  return PaintPoint{ray.origin + t * ray.direction, normal};
}

std::optional<PaintPoint> free_point(const PaintTarget& target, const glm::dvec3& pivot,
                                     const glm::dvec3& forward, const FilmRay& ray,
                                     SurfacePicker& surfaces) {
  const auto across_axis = [&](const glm::dvec3& axis) {
    return on_plane(target.position * axis, axis, ray);
  };
  switch (target.plane) {
    case PaintPlane::view:
      return on_plane(pivot, -forward, ray);
    case PaintPlane::ground:
      return across_axis({0.0, 1.0, 0.0});
    case PaintPlane::wall_x:
      return across_axis({1.0, 0.0, 0.0});
    case PaintPlane::wall_z:
      return across_axis({0.0, 0.0, 1.0});
    case PaintPlane::surface:
      if (const auto hit = surfaces.hit(ray.origin, ray.direction)) {
        return PaintPoint{hit->position, hit->normal};
      }
  }
  return std::nullopt;
}

}  // namespace

std::optional<PaintPoint> paint_point(const PaintTarget& target, const glm::dvec3& pivot,
                                      const CameraRays& rays, QPointF position,
                                      SurfacePicker& surfaces) {
  const FilmRay ray{rays.origin(position.x(), position.y()),
                    rays.direction(position.x(), position.y())};
  if (target.snap == Snap::surface) {
    if (const auto hit = surfaces.hit(ray.origin, ray.direction)) {
      return PaintPoint{hit->position, hit->normal};
    }
  }
  auto point = free_point(target, pivot, rays.forward(), ray, surfaces);
  if (point && target.snap == Snap::grid) {
    point->position = glm::round(point->position / target.grid) * target.grid;
  }
  return point;
}

void add_brush_cursor(Overlay& overlay, const CameraRays& rays, const PaintPoint& point,
                      double radius) {
  const QColor accent = accent_color();
  overlay.add_outline(rays, {.center = point.position, .radius = radius},
                      qRgba(accent.red(), accent.green(), accent.blue(), 230));
  // The plane as a net around the brush that fades outwards.
  const auto [u, v] = make_basis(point.normal);
  constexpr int cells = 4;
  for (int k = -cells; k <= cells; ++k) {
    for (int j = -cells; j < cells; ++j) {
      const double center = std::hypot(k, j + 0.5) / cells;
      if (center >= 1.0) continue;
      const QRgb color = qRgba(255, 255, 255, static_cast<int>(70.0 * (1.0 - center)));
      const glm::dvec3 pivot = point.position;
      const double a = radius * k;
      const double b = radius * j;
      const double c = radius * (j + 1);
      overlay.add_line(rays, pivot + a * u + b * v, pivot + a * u + c * v, color);
      overlay.add_line(rays, pivot + b * u + a * v, pivot + c * u + a * v, color);
    }
  }
}

}  // namespace brume
