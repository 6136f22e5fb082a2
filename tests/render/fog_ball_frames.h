#pragma once

#include <glm/vec3.hpp>

#include "brume/frame.h"
#include "brume/scene.h"

namespace brume {

// Scenes of homogeneous fog in a ball (`medium.extent`), and closed forms and plain integrals of
// what is seen of it.

// Fog of depth 1 through the middle of a ball of radius 1, seen from `eye`.
Scene fog_ball_scene(const glm::dvec3& eye = {0.0, 0.3, 3.0});
// The same with walls in front of the ball, through its middle and behind it, each on another part
// of the film.
Scene fog_ball_between_walls();

// Where fog ends on the way of a pixel's ray, the surface it hits or +inf.
struct FogBallRay {
  glm::dvec3 origin{0.0};
  glm::dvec3 w{0.0};
  double begin = 0.0, end = 0.0;  // in fog, before the surface
};
FogBallRay fog_ray_of(const Scene& scene, const Frame& frame, std::size_t pixel);

// exp(-depth) of a pixel of a frame of one albedo.
double fog_transmittance(const Scene& scene, const Frame& frame, std::size_t pixel);

// Airlight of a pixel of light that the ball scatters once, red, of the lights that are on: point
// lights and directional ones; without shadows.
double scattered_once(const Scene& scene, const Frame& frame, std::size_t pixel);

// The relative root-mean-square error of the airlight of a frame against scattered_once().
double scattered_once_error(const Scene& scene, const Frame& frame);
// The greatest error of its transmittance.
double fog_transmittance_error(const Scene& scene, const Frame& frame);

}  // namespace brume
