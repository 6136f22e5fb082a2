#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/scene/scene.h"

namespace brume {

// Directional lights as point lights that are far away: what evaluates point lights evaluates them.

// Bounds of surfaces and Gaussians (3 radii each); nullopt without any. Reads all vertices.
struct LitBounds {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};
};
std::optional<LitBounds> lit_bounds(const Scene& scene);

// What far lights shine on: surfaces and Gaussians (3 radii each), or else the fog within a mean
// free path of the origin. In coarse steps, so that it mostly stays while a medium is painted.
struct LitRegion {
  glm::dvec3 center{0.0};
  double diameter = 2.0;  // [u]

  static LitRegion of(const Scene& scene);
};

// A far light is this many diameters of the region away. Over the region its irradiance differs by
// at most 0.06%, its direction by 0.016 degrees, in fog around it by twice as much; single
// precision still tells points in the region apart at a 4000th of it.
inline constexpr double far_light_distance = 2048.0;

// The unit direction towards it; straight up where keyframes pass length 0.
glm::dvec3 to_light(const Directional& light);

// The light, or for a directional one the point light that stands for its center. `directional`
// remains, and tells that it is far away.
Light as_point_light(const Light& light, const LitRegion& region);

// Those that are on and not black, in their order; of a directional light with an angular diameter
// `disc_points` >= 1 lights spread evenly over its disc.
std::vector<Light> as_point_lights(const Scene& scene, int disc_points = 1);

}  // namespace brume
