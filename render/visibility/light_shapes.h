#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/scene.h"
#include "core/scene/lights/area_lights.h"
#include "core/scene/lights/point_lights.h"
#include "render/visibility/surface_hit.h"

namespace brume {

// The shape of a light that is seen.
struct LightShape {
  AreaLight area;
  glm::dvec3 center{0.0};
  glm::vec3 radiance{0.0f};  // RGB [W/(sr u^2)]
  std::size_t light = 0;     // index in the scene

  bool operator==(const LightShape&) const = default;
};

// The lights of a scene whose shapes are seen: view rays end there, and so do those that smooth
// surfaces mirror. All other rays pass them, since lights keep no light out. The side of a light
// that does not shine is passed, too. Shapes are exact, not triangles, and no part of the ray
// caster: what a light shows changes nothing that is prepared of surfaces.
class LightShapes {
 public:
  LightShapes() = default;
  explicit LightShapes(std::span<const Light> lights);

  [[nodiscard]] bool empty() const { return shapes_.empty(); }
  [[nodiscard]] const std::vector<LightShape>& all() const { return shapes_; }
  // The shape of a hit on a light.
  [[nodiscard]] const LightShape& of(const SurfaceHit& hit) const { return shapes_[hit.light()]; }

  // Replaces the hit of a ray in this unit direction by that on a light, if it is nearer. Lights
  // that lie on a surface are in front of it. Thread-safe.
  void meet(const glm::dvec3& origin, const glm::dvec3& direction, SurfaceHit& hit) const;
  // The same for view rays, see RayCaster::first_hits().
  void meet(const glm::dvec3& eye, std::span<const glm::dvec3> directions,
            std::span<const glm::dvec3> offsets, std::span<SurfaceHit> hits) const;

 private:
  void meet(std::size_t shape, const glm::dvec3& origin, const glm::dvec3& direction,
            SurfaceHit& hit) const;

  std::vector<LightShape> shapes_;
  std::vector<double> radii_;  // of the balls around them [u]
};

// Hits of surfaces are not exact: those of lights of that radius [u] that lie on them may be so
// much farther away [u].
double light_margin(const AreaHit& hit, double radius);

// A point of a light's shape after the light has become another one of its kind.
glm::dvec3 moved_on_shape(const AreaLight& now, const glm::dvec3& now_center, const AreaLight& next,
                          const glm::dvec3& next_center, const glm::dvec3& point);

// The unit normal of a shape at a point of it, towards the side that a ray in this direction meets.
glm::dvec3 shape_normal(const LightShape& shape, const glm::dvec3& point,
                        const glm::dvec3& direction);

}  // namespace brume
