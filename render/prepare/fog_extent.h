#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

#include "brume/scene.h"
#include "core/math/infinity.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"
#include "render/geometry/box.h"
#include "render/geometry/fog_ball.h"
#include "render/scattering/lit_space.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Extent of the homogeneous fog. With `medium.extent` it is a ball around the middle of the scene:
// of lit_bounds(), or the origin without any. Else
// view rays and near lights cross it all the way, and it is infinite without an environment or a
// directional light, which infinite fog would hide; for their light it ends at the distance D of
// eq. 26: the diagonal of these bounds, or 1 / b0 without it.
class FogExtent {
 public:
  explicit FogExtent(const Scene& scene);

  // Where there is fog: in the ball of `medium.extent`; endless without.
  [[nodiscard]] const FogBall& fog() const { return fog_; }
  // The fog that light from far away crosses: that ball, or one of radius D around the same middle.
  [[nodiscard]] const FogBall& ball() const { return ball_; }
  // Whether there is fog, and a directional light or an environment, whose light crosses it.
  [[nodiscard]] bool has_far_light() const { return has_far_light_; }
  // The radius of ball() [u]; +inf where it is infinite, or without fog.
  [[nodiscard]] double surface_distance() const { return ball_.radius; }
  // Optical depth of fog of density b0 [1/u] over D where it is taken for that from anywhere to
  // its end; 0 without fog, and where fog() is a ball, which tells each way through it.
  [[nodiscard]] double surface_optical_depth(double b0) const {
    return b0 > 0.0 && fog_.is_endless() ? b0 * ball_.radius : 0.0;
  }
  // Length of a view ray that hits nothing: D, and all of a ball, beyond the center of the scene.
  [[nodiscard]] double ray_distance(const glm::dvec3& eye) const;
  [[nodiscard]] double ray_distance(const CameraRays& rays) const;

 private:
  FogBall fog_, ball_;
  bool has_far_light_ = false;
  double view_radius_ = infinity;  // of what view rays see around the middle [u]
};

// FogExtent::fog() of a scene, whose vertices it reads only if it has a `medium.extent`.
FogBall fog_of(const Scene& scene);

// The box in which fog of density b0 > 0 [1/u] without surfaces needs the finest nodes for light
// that it scatters more than once: around these lights but directional ones, or around the origin,
// as far as the eye is from the nearest, but at most two mean free paths. It goes in steps, of a
// sixteenth of its size at least, and of powers of 2 of that distance: mostly it stays while a
// light or the eye moves.
Box fog_bounds(double b0, std::span<const PointLight> lights, const glm::dvec3& eye);
// Among surfaces, with lights that are not far away at these places. The fog that needs the finest
// nodes is the part of the surfaces' bounds around lights that are near surfaces, some times as far
// as these are, but no less than coarser levels can go on from: to all surfaces, and as far as fog
// scatters (`reach`); and the room around the eye, if it is in one. It is all of the bounds if that
// would save little. With space above what is flat, but none on sides where surfaces hide it from
// these lights: nodes below a ground or behind the walls of a tunnel would be lost. It stays while
// lights move a little.
LitSpace space_lit_near(const RayCaster& surfaces, std::span<const glm::dvec3> lights,
                        const std::optional<Box>& room, double reach);
// Whether surfaces keep all light of lights at these places in, however often it is scattered.
bool close_in(const RayCaster& surfaces, std::span<const glm::dvec3> lights);
// Bounds of the surfaces that hide nine tenths of the directions around a place, but for those as
// wide as a ground; nullopt if it is in the open, or if they are more than a third as wide as
// all surfaces: then nodes for all of these do.
std::optional<Box> room_around(const RayCaster& surfaces, const glm::dvec3& place);
// If surfaces hide nine tenths of the directions around a place: the room there, or the bounds of
// all surfaces if these are one room.
std::optional<Box> closed_room_around(const RayCaster& surfaces, const glm::dvec3& place);
// Whether surfaces hide three quarters of the directions around a place.
bool is_indoors(const RayCaster& surfaces, const glm::dvec3& place);

// The share of light from far away that homogeneous fog lets through to the middle of the scene, of
// a scene with a directional light or an environment (see FogExtent); else 1.
double transmittance_of_fog(const Scene& scene);

// A warning where that is less than half. It says how far the fog reaches, and what would help.
std::optional<std::string> deep_fog_text(const Scene& scene);

}  // namespace brume
