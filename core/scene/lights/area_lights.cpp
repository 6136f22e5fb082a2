#include "core/scene/lights/area_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/basis.h"
#include "core/math/unit_direction.h"
#include "core/overloaded.h"

namespace brume {
namespace {

using std::numbers::pi;

// Twice what an edge from a to b, relative to the receiver, adds to Lambert's sum.
double edge_irradiance(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normal) {
  const glm::dvec3 turn = glm::cross(a, b);
  const double sine = glm::length(turn);
  return sine > 0.0 ? std::atan2(sine, glm::dot(a, b)) * glm::dot(turn, normal) / sine : 0.0;
}

double polygon_irradiance(const AreaOutline& outline, const glm::dvec3& x,
                          const glm::dvec3& normal) {
  double sum = 0.0;
  glm::dvec3 leaves(0.0), enters(0.0);  // where the outline crosses the horizon
  for (int k = 0; k < outline.corner_count; ++k) {
    glm::dvec3 a = outline.corner(k) - x;
    glm::dvec3 b = outline.corner(k + 1) - x;
    const double height_a = glm::dot(a, normal);
    const double height_b = glm::dot(b, normal);
    if (height_a <= 0.0 && height_b <= 0.0) continue;
    const glm::dvec3 crossing = a + height_a / (height_a - height_b) * (b - a);
    if (height_a <= 0.0) enters = a = crossing;
    if (height_b <= 0.0) leaves = b = crossing;
    sum += edge_irradiance(a, b, normal);
  }
  return 0.5 * (sum + edge_irradiance(leaves, enters, normal));
}

// `to_center` from the receiver.
double sphere_irradiance(const light::Sphere& sphere, const glm::dvec3& to_center,
                         const glm::dvec3& normal) {
  const double distance = glm::length(to_center);
  if (distance <= sphere.radius) return sphere.two_sided ? pi : 0.0;
  const double h = distance / sphere.radius;
  const double cosine = std::clamp(glm::dot(to_center, normal) / distance, -1.0, 1.0);
  if (h * cosine >= 1.0) return pi * cosine / (h * h);
  if (h * cosine <= -1.0) return 0.0;
  const double beyond = h * h - 1.0;
  const double cut = 1.0 - h * h * cosine * cosine;
  const double share =
      std::clamp(-cosine * std::sqrt(beyond / std::max(1.0 - cosine * cosine, 1e-300)), -1.0, 1.0);
  return (cosine * std::acos(share) - std::sqrt(cut * beyond)) / (h * h) +
         std::atan2(std::sqrt(cut), std::sqrt(beyond));
}

std::optional<AreaHit> hit_sphere(const light::Sphere& sphere, const glm::dvec3& to_center,
                                  const glm::dvec3& w) {
  const double along = glm::dot(to_center, w);
  const glm::dvec3 beside = to_center - along * w;
  const double square = sphere.radius * sphere.radius - glm::dot(beside, beside);
  if (!(square > 0.0)) return std::nullopt;
  const double half_chord = std::sqrt(square);
  const bool is_within = glm::length(to_center) <= sphere.radius;
  if (is_within && !sphere.two_sided) return std::nullopt;
  const double distance = is_within ? along + half_chord : along - half_chord;
  return distance > 0.0 ? std::optional(AreaHit{distance, half_chord / sphere.radius})
                        : std::nullopt;
}

// Of a plane of this unit normal.
std::optional<AreaHit> hit_plane(const AreaLight& area, const glm::dvec3& normal,
                                 const glm::dvec3& to_center, const glm::dvec3& w) {
  const double approach = -glm::dot(normal, w);
  if (approach == 0.0 || (approach < 0.0 && !is_two_sided(area))) return std::nullopt;
  const double distance = -glm::dot(to_center, normal) / approach;
  if (!(distance > 0.0)) return std::nullopt;
  const glm::dvec3 place = distance * w - to_center;
  const bool hits = std::visit(
      Overloaded{[&](const light::Rectangle& rectangle) {
                   const auto [right, up] = rectangle_axes(rectangle);
                   return std::abs(glm::dot(place, right)) <= 0.5 * rectangle.width &&
                          std::abs(glm::dot(place, up)) <= 0.5 * rectangle.height;
                 },
                 [&](const light::Disk& disk) { return glm::length(place) <= disk.radius; },
                 [](const light::Sphere&) { return false; }},
      area);
  return hits ? std::optional(AreaHit{distance, std::abs(approach)}) : std::nullopt;
}

}  // namespace

AreaOutline::AreaOutline(const AreaLight& area, const glm::dvec3& area_center, int disk_corners)
    : center(area_center) {
  const auto set = [this](int count, const glm::dvec3& first, const glm::dvec3& second,
                          const glm::dvec3& normal) {
    corner_count = count;
    const bool is_clockwise = glm::dot(glm::cross(first, second), normal) < 0.0;
    u = is_clockwise ? first : second;
    v = is_clockwise ? second : first;
  };
  std::visit(
      Overloaded{[&](const light::Rectangle& rectangle) {
                   constexpr double half_diagonal = std::numbers::sqrt2 / 2.0;
                   const auto [right, up] = rectangle_axes(rectangle);
                   set(4, half_diagonal * rectangle.width * right,
                       half_diagonal * rectangle.height * up, rectangle.direction);
                 },
                 [&](const light::Disk& disk) {
                   const glm::dvec3 normal = unit_direction(disk.direction, {0.0, -1.0, 0.0});
                   const auto [right, up] = make_basis(normal);
                   const double turn = 2.0 * pi / disk_corners;
                   const double radius = disk.radius * std::sqrt(turn / std::sin(turn));
                   set(disk_corners, radius * right, radius * up, normal);
                 },
                 [](const light::Sphere&) {}},
      area);
}

glm::dvec3 AreaOutline::corner(int k) const {
  const double t = 2.0 * pi * (k + 0.5) / corner_count;
  return center + std::cos(t) * u + std::sin(t) * v;
}

double area_irradiance(const AreaLight& area, const glm::dvec3& center, const glm::dvec3& x,
                       const glm::dvec3& normal) {
  if (const auto* sphere = std::get_if<light::Sphere>(&area)) {
    return sphere_irradiance(*sphere, center - x, normal);
  }
  const double sum = polygon_irradiance({area, center, 512}, x, normal);
  return is_two_sided(area) ? std::abs(sum) : std::max(sum, 0.0);
}

std::optional<AreaHit> hit_area(const AreaLight& area, const glm::dvec3& center,
                                const glm::dvec3& origin, const glm::dvec3& w) {
  const glm::dvec3 to_center = center - origin;
  const auto plane = [&](const auto& shape) {
    return hit_plane(area, unit_direction(shape.direction, {0.0, -1.0, 0.0}), to_center, w);
  };
  return std::visit(
      Overloaded{[&](const light::Rectangle& rectangle) { return plane(rectangle); },
                 [&](const light::Disk& disk) { return plane(disk); },
                 [&](const light::Sphere& sphere) { return hit_sphere(sphere, to_center, w); }},
      area);
}

}  // namespace brume
