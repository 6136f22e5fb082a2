#include "render/visibility/light_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/math/basis.h"
#include "core/math/unit_direction.h"
#include "core/overloaded.h"
#include "render/geometry/rounding.h"

namespace brume {

double light_margin(const AreaHit& hit, double radius) {
  constexpr double min_cosine = 0.01;
  return 4.0 * position_rounding * (hit.distance + radius) / std::max(hit.cosine, min_cosine);
}

namespace {

// A cone around directions.
struct Cone {
  glm::dvec3 axis{0.0};
  double half_angle = 0.0;  // [radians]

  explicit Cone(std::span<const glm::dvec3> directions) {
    for (const glm::dvec3& w : directions) axis += w;
    axis = unit_direction(axis, {0.0, 0.0, 1.0});
    double cosine = 1.0;
    for (const glm::dvec3& w : directions) cosine = std::min(cosine, glm::dot(axis, w));
    constexpr double cosine_error = 1e-6;  // [radians]
    half_angle = std::acos(std::clamp(cosine, -1.0, 1.0)) + cosine_error;
  }

  // Whether it may meet a ball, from its apex.
  [[nodiscard]] bool reaches(const glm::dvec3& to_center, double radius) const {
    const double distance = glm::length(to_center);
    if (distance <= radius) return true;
    const double cosine = std::clamp(glm::dot(to_center, axis) / distance, -1.0, 1.0);
    return std::acos(cosine) <= half_angle + std::asin(radius / distance);
  }
};

// Vectors along the axes of a shape, as long as it is.
glm::dmat3 axes_of(const AreaLight& area) {
  return std::visit(
      Overloaded{[](const light::Rectangle& rectangle) {
                   const auto [right, up] = rectangle_axes(rectangle);
                   return glm::dmat3(rectangle.width * right, rectangle.height * up,
                                     glm::cross(right, up));
                 },
                 [](const light::Disk& disk) {
                   const glm::dvec3 normal = unit_direction(disk.direction, {0.0, -1.0, 0.0});
                   const auto [right, up] = make_basis(normal);
                   return glm::dmat3(disk.radius * right, disk.radius * up, normal);
                 },
                 [](const light::Sphere& sphere) { return glm::dmat3(sphere.radius); }},
      area);
}

}  // namespace

LightShapes::LightShapes(std::span<const Light> lights) {
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (!is_seen(lights[i])) continue;
    const AreaLight area = *area_of(lights[i]);
    shapes_.push_back({area, lights[i].position, glm::vec3(lights[i].intensity), i});
    radii_.push_back(bounding_radius(area));
  }
}

void LightShapes::meet(std::size_t shape, const glm::dvec3& origin, const glm::dvec3& direction,
                       SurfaceHit& hit) const {
  // Most rays pass by.
  const glm::dvec3 to_center = shapes_[shape].center - origin;
  const double along = glm::dot(to_center, direction);
  const double radius = radii_[shape];
  const double beside = glm::dot(to_center, to_center) - along * along;
  constexpr double rounding = 1e-9;
  if (beside > radius * radius * (1.0 + rounding) + rounding * along * along) return;
  const auto met = hit_area(shapes_[shape].area, shapes_[shape].center, origin, direction);
  if (!met || met->distance > hit.distance + light_margin(*met, radius)) return;
  hit = SurfaceHit::on_light(met->distance, shape);
}

void LightShapes::meet(const glm::dvec3& origin, const glm::dvec3& direction,
                       SurfaceHit& hit) const {
  for (std::size_t shape = 0; shape < shapes_.size(); ++shape) meet(shape, origin, direction, hit);
}

void LightShapes::meet(const glm::dvec3& eye, std::span<const glm::dvec3> directions,
                       std::span<const glm::dvec3> offsets, std::span<SurfaceHit> hits) const {
  if (empty() || directions.empty()) return;
  const Cone cone(directions);
  for (std::size_t shape = 0; shape < shapes_.size(); ++shape) {
    if (offsets.empty() && !cone.reaches(shapes_[shape].center - eye, radii_[shape])) continue;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      meet(shape, offsets.empty() ? eye : eye + offsets[k], directions[k], hits[k]);
    }
  }
}

glm::dvec3 moved_on_shape(const AreaLight& now, const glm::dvec3& now_center, const AreaLight& next,
                          const glm::dvec3& next_center, const glm::dvec3& point) {
  return next_center + axes_of(next) * (glm::inverse(axes_of(now)) * (point - now_center));
}

glm::dvec3 shape_normal(const LightShape& shape, const glm::dvec3& point,
                        const glm::dvec3& direction) {
  const glm::dvec3 normal = std::holds_alternative<light::Sphere>(shape.area)
                                ? unit_direction(point - shape.center, -direction)
                                : glm::normalize(axes_of(shape.area)[2]);
  return glm::dot(normal, direction) > 0.0 ? -normal : normal;
}

}  // namespace brume
