#include "app/view/camera/walls.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <vector>

#include "app/view/camera/navigation.h"
#include "app/view/surface_picker.h"
#include "core/scene/camera_rays.h"

namespace brume {
namespace {

// Sides of one wall are at most this share of the way apart.
constexpr double max_thickness = 0.1;

bool is_blocked(SurfacePicker& surfaces, const glm::dvec3& start, const glm::dvec3& end) {
  const double length = glm::distance(start, end);
  if (!(length > 0.0)) return false;
  const auto hit = surfaces.hit(start, (end - start) / length);
  return hit && glm::distance(start, hit->position) < length;
}

// Points in the room, before what is seen from inside.
std::vector<glm::dvec3> points_in_room(SurfacePicker& surfaces, const Camera& inside,
                                       const Film& film) {
  constexpr double share = 0.5;  // of the way to what is seen
  const CameraRays rays(inside, film);
  std::vector<glm::dvec3> points;
  for (const double y : {0.2, 0.5, 0.8}) {
    for (const double x : {0.2, 0.5, 0.8}) {
      const glm::dvec3 w = rays.direction(x * film.width, y * film.height);
      const auto hit = surfaces.hit(inside.eye, w);
      const double distance =
          hit ? glm::distance(inside.eye, hit->position) : target_distance(inside);
      points.push_back(inside.eye + share * distance * w);
    }
  }
  return points;
}

// The inner side of the first wall on the way; nullopt: there is none.
std::optional<ClipPlane> inner_side(SurfacePicker& surfaces, const glm::dvec3& eye,
                                    const glm::dvec3& point) {
  constexpr int max_sides = 8;
  const double length = glm::distance(eye, point);
  const glm::dvec3 w = (point - eye) / length;
  std::optional<ClipPlane> side;
  double passed = 0.0;
  for (int k = 0; k < max_sides; ++k) {
    const auto hit = surfaces.hit(eye + passed * w, w);
    if (!hit) break;
    const double distance = glm::dot(hit->position - eye, w);
    if (distance > length || (side && distance > passed + max_thickness * length)) break;
    // Normals are on the side that is seen.
    side = ClipPlane{hit->position - 1e-3 * length * hit->normal, -hit->normal};
    passed = distance + 1e-6 * length;
  }
  return side;
}

}  // namespace

std::array<ClipPlane, 4> walls_before(SurfacePicker& surfaces, const Camera& inside,
                                      const Camera& now, const Film& film) {
  std::array<ClipPlane, 4> walls{};
  if (!is_blocked(surfaces, inside.eye, now.eye)) return walls;
  std::vector<glm::dvec3> points = points_in_room(surfaces, inside, film);
  const auto is_before = [](const glm::dvec3& point, const ClipPlane& plane) {
    return glm::dot(point - plane.point, plane.normal) < 0.0;
  };
  std::size_t count = 0;
  for (const glm::dvec3& point : points) {
    if (glm::dot(point - now.eye, now.target - now.eye) <= 0.0) continue;
    const auto wall = inner_side(surfaces, now.eye, point);
    if (!wall || count == walls.size()) continue;
    const auto known = std::span(walls).first(count);
    const bool is_known = std::ranges::any_of(
        known, [&](const ClipPlane& other) { return is_before(wall->point, other); });
    // Furniture has a part of the room before it.
    const bool is_inside = std::ranges::any_of(
        points, [&](const glm::dvec3& other) { return is_before(other, *wall); });
    if (!is_known && !is_inside && !is_before(inside.eye, *wall)) walls.at(count++) = *wall;
  }
  return walls;
}

}  // namespace brume
