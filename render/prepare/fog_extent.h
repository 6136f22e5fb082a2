#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"
#include "render/geometry/box.h"
#include "render/geometry/fog_ball.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Extent of the homogeneous fog. It is infinite without an environment or a directional light,
// which infinite fog would hide; with one it ends at the distance D of eq. 26: the diagonal of the
// bounding box of surfaces and Gaussians (3 radii each), or 1 / b0 without any.
class FogExtent {
 public:
  explicit FogExtent(const Scene& scene);

  // D for points on surfaces [u]; +inf where it is infinite, or without fog.
  [[nodiscard]] double surface_distance() const { return ball_.radius; }
  // Optical depth of fog of density b0 [1/u] over D; 0 without fog.
  [[nodiscard]] double surface_optical_depth(double b0) const {
    return b0 > 0.0 ? b0 * ball_.radius : 0.0;
  }
  // Around the middle of surfaces and Gaussians; D is its radius.
  [[nodiscard]] const FogBall& ball() const { return ball_; }
  // Length of a view ray that hits nothing: D beyond the center of the scene.
  [[nodiscard]] double ray_distance(const glm::dvec3& eye) const;
  [[nodiscard]] double ray_distance(const CameraRays& rays) const;

 private:
  FogBall ball_;
};

// Where fog of density b0 > 0 [1/u] without surfaces scatters light more than once: two mean free
// paths around these lights but directional ones, or around the origin. In steps of at least a
// sixteenth of its size, so that it mostly stays while a light is dragged.
Box fog_bounds(double b0, std::span<const PointLight> lights);
// The part of the surfaces' bounds where fog needs the finest nodes: around lights that are near
// surfaces, some times as far as these are, but no less than coarser levels can go on from: to all
// surfaces, and as far as fog scatters (`reach`); and the room around the eye, if it is in one. All
// of the bounds if that would save little. With space above what is flat, but none on sides where
// surfaces hide it from the eye and the lights: nodes below a ground or behind the walls of a
// tunnel would be lost. It stays while lights move a little.
Box finest_fog_bounds(const RayCaster& surfaces, std::span<const PointLight> lights,
                      const std::optional<Box>& room, const glm::dvec3& eye, double reach);
// Bounds of the surfaces that hide nine tenths of the directions around a place, but for those as
// wide as a ground; nullopt if it is in the open, or if they are more than a third as wide as
// all surfaces: then nodes for all of these do.
std::optional<Box> room_around(const RayCaster& surfaces, const glm::dvec3& place);

}  // namespace brume
