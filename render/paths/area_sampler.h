#pragma once

#include <glm/vec3.hpp>

#include "core/scene/lights/point_lights.h"
#include "render/paths/path_random.h"

namespace brume {

// Draws points of an area light at random. Light that leaves a sphere outwards reaches only what is
// outside it, and light inwards only what is inside.
class AreaSampler {
 public:
  AreaSampler(const AreaLight& area, const glm::dvec3& center);

  struct Point {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};  // unit, of the front; 0 of a point light
  };
  // Evenly over the surface.
  [[nodiscard]] Point on_surface(PathRandom& random) const;
  // The radiant intensity of a point towards x, relative to that along its normal.
  [[nodiscard]] double cosine(const Point& point, const glm::dvec3& x) const;

  // Whether any of it is sent to x.
  [[nodiscard]] bool shines_to(const glm::dvec3& x) const;

  // Evenly over the solid angle that the light fills at x, or over the surface where that makes
  // less noise. The mean of factor / r^2 is that solid angle over the surface's area.
  struct SeenPoint {
    glm::dvec3 position{0.0};
    double factor = 0.0;
  };
  [[nodiscard]] SeenPoint seen_from(const glm::dvec3& x, PathRandom& random) const;
  // Density of finding there a point of the light that shines to x, per solid angle [1/sr].
  [[nodiscard]] double direction_pdf(const glm::dvec3& x, const glm::dvec3& position) const;

 private:
  // 1 - cos of the cone from x that is drawn from.
  [[nodiscard]] double sphere_versine(const glm::dvec3& x) const;
  // From x to the middle of a plane, along its sides and towards it.
  [[nodiscard]] glm::dvec3 to_plane(const glm::dvec3& x) const;
  // The solid angle that is drawn from; 0 where points are drawn evenly over the surface.
  [[nodiscard]] double plane_solid_angle(const glm::dvec3& x) const;
  [[nodiscard]] SeenPoint seen_on_sphere(const glm::dvec3& x, PathRandom& random) const;
  [[nodiscard]] SeenPoint seen_on_plane(const glm::dvec3& x, PathRandom& random) const;
  // The points of a plane that faces the way `direction`, in a rectangle around it.
  void set_plane(const light::Rectangle& rectangle);

  bool is_disk_, is_sphere_, is_two_sided_;
  glm::dvec3 center_;
  glm::dvec3 normal_{0.0}, right_{0.0}, up_{0.0};  // unit; not of a sphere
  double half_width_ = 0.0, half_height_ = 0.0;
  double radius_ = 0.0;  // of a disk or sphere
  double surface_area_;
};

}  // namespace brume
