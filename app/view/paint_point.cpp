#include "app/view/paint_point.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/view/surface_picker.h"
#include "app/view/view.h"
#include "core/authoring/contribution.h"
#include "core/math/infinity.h"

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
  return PaintPoint{ray.origin + t * ray.direction, normal, t};
}

std::optional<PaintPoint> on_surface(View& view, const FilmRay& ray, double radius,
                                     bool stands = false) {
  const auto hit = view.surfaces().hit_in_view(view.rays(), ray.origin, ray.direction);
  if (!hit) return std::nullopt;
  // The ball touches the surface unless that is seen at a flat angle, where it would come much
  // nearer: on the mouse's ray nine tenths of its optical depth are in front all the same. It does
  // not come so near either that it would look much larger there.
  const double least_cosine = stands ? 0.0 : 0.7;
  const double most = stands ? 1.0 / 2.0 : 1.0 / 3.0;
  const double distance = glm::distance(hit->position, ray.origin);
  const double cosine = std::abs(glm::dot(ray.direction, hit->normal));
  const double back = std::min(radius / std::max(cosine, least_cosine), most * distance);
  return PaintPoint{hit->position - back * ray.direction, hit->normal, distance, true};
}

std::optional<PaintPoint> begin_under_mouse(View& view, const FilmRay& ray, double radius,
                                            bool stands) {
  const glm::dvec3 towards_eye = -view.rays().forward();
  const auto in_air = [&](double distance) {
    return PaintPoint{ray.origin + distance * ray.direction, towards_eye, distance};
  };
  const FogOnRay fog = view.fog_on(ray.origin, ray.direction);
  auto point = on_surface(view, ray, radius, stands);
  if (!point) {
    const auto middle = fog.middle_of_gaussians(min_pointed_effect);
    point = middle ? in_air(*middle) : on_plane(view.pivot(), towards_eye, ray);
  }
  const double seen = fog.distance_at(std::numbers::ln2);
  const bool is_hidden = !point || point->distance > seen;
  return is_hidden && std::isfinite(seen) ? in_air(seen) : point;
}

std::optional<PaintPoint> continue_under_mouse(View& view, const FilmRay& ray, double radius,
                                               const StrokeDepth& stroke) {
  const bool began_on_surface = stroke.first.on_surface;
  const PaintPoint& level = began_on_surface ? stroke.last : stroke.first;
  const auto in_air = on_plane(level.unsnapped, -view.rays().forward(), ray);
  const auto surface = on_surface(view, ray, radius);
  if (!surface) return in_air;
  constexpr double leap = 1.5;
  const double end = began_on_surface ? leap * stroke.farthest
                     : in_air         ? in_air->distance
                                      : infinity;
  return surface->distance <= end ? surface : in_air;
}

std::optional<PaintPoint> free_point(View& view, const PaintTarget& target, const FilmRay& ray,
                                     double radius, const std::optional<StrokeDepth>& stroke) {
  const auto across_axis = [&](const glm::dvec3& axis) {
    return on_plane(target.position * axis, axis, ray);
  };
  switch (target.plane) {
    case PaintPlane::under_mouse:
      return stroke ? continue_under_mouse(view, ray, radius, *stroke)
                    : begin_under_mouse(view, ray, radius, target.stands);
    case PaintPlane::view:
      return on_plane(stroke ? stroke->first.unsnapped : view.pivot(), -view.rays().forward(), ray);
    case PaintPlane::ground:
      return across_axis({0.0, 1.0, 0.0});
    case PaintPlane::wall_x:
      return across_axis({1.0, 0.0, 0.0});
    case PaintPlane::wall_z:
      return across_axis({0.0, 0.0, 1.0});
    case PaintPlane::surface:
      return on_surface(view, ray, 0.0);
  }
  return std::nullopt;
}

}  // namespace

bool is_depth_jump(const CameraRays& rays, const PaintPoint& last, const PaintPoint& next,
                   double radius) {
  const auto depth = [&](const PaintPoint& point) {
    return std::abs(glm::dot(point.position - rays.eye(), rays.forward()));
  };
  const auto [near, far] = std::minmax({depth(last), depth(next)});
  return far - near > std::max(2.0 * radius, far / 8.0);
}

void StrokeDepth::extend(const PaintPoint& point) {
  last = point;
  farthest = std::max(farthest, point.distance);
}

std::optional<PaintPoint> paint_point(View& view, const PaintTarget& target, QPointF position,
                                      double radius, const std::optional<StrokeDepth>& stroke) {
  const CameraRays rays = view.rays();
  const FilmRay ray{rays.origin(position.x(), position.y()),
                    rays.direction(position.x(), position.y())};
  auto point = free_point(view, target, ray, radius, stroke);
  if (point) point->unsnapped = point->position;
  if (point && target.snaps_to_grid) {
    point->position = glm::round(point->position / target.grid) * target.grid;
  }
  return point;
}

}  // namespace brume
