#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/scene/lights/point_lights.h"

namespace brume {

// The outline of a rectangle, or of a disk as a polygon of as much area: its corners lie on an
// ellipse around the middle, clockwise as seen from the side that shines.
struct AreaOutline {
  int corner_count = 0;  // 0: of a sphere, which has none
  glm::dvec3 center{0.0};
  glm::dvec3 u{0.0}, v{0.0};  // half axes of the ellipse [u]

  AreaOutline(const AreaLight& area, const glm::dvec3& area_center, int disk_corners);
  // center + cos(t) u + sin(t) v, t = 2 pi (k + 1/2) / corner_count.
  [[nodiscard]] glm::dvec3 corner(int k) const;
};

// Irradiance, per radiance of the light, that an area light around `center` sends to a surface at x
// of this unit normal, if nothing is in its way [sr], in [0, pi]. Of polygons Lambert's sum over
// the edges above the horizon (Photometria, 1760; Arvo 1994), a disk is one of 512 sides; of
// spheres the form factor of Naraghi and Chung (1982), which the horizon may cut.
double area_irradiance(const AreaLight& area, const glm::dvec3& center, const glm::dvec3& x,
                       const glm::dvec3& normal);

// Where the ray from `origin` in the unit direction w first meets a side of it that shines, and the
// cosine there, > 0 [u]; nullopt where it meets none.
struct AreaHit {
  double distance;
  double cosine;
};
std::optional<AreaHit> hit_area(const AreaLight& area, const glm::dvec3& center,
                                const glm::dvec3& origin, const glm::dvec3& w);

}  // namespace brume
