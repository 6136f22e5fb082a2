#pragma once

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/scene/camera_rays.h"

namespace brume {

// Minimum distance of a point light from a view ray (see PointLightRay), the same for all methods:
// 1/20 of the pixel's footprint at the light. In-scattered radiance grows like 1 / distance, so a
// ray through the light is about ten times as bright as the mean over its pixel, and only one ray
// in a hundred pixels around a light is clamped.
inline double min_light_distance(const CameraRays& rays, const Camera& camera,
                                 const glm::dvec3& light) {
  // A light at the eye has no footprint; a hundredth of the distance to the target is used instead.
  const double distance =
      std::max(glm::length(light - camera.eye), 0.01 * glm::length(camera.target - camera.eye));
  return 0.05 * 2.0 * rays.pixel_half_angle() * distance + 0.05 * rays.pixel_width();
}

}  // namespace brume
