#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/lights/radiance_map.h"

namespace brume {

// A directional light that represents a solid angle of an environment.
struct DistantLight {
  glm::dvec3 direction;   // towards it, unit
  glm::dvec3 irradiance;  // RGB: radiance times solid angle [W/u^2]
};

// Approximates a map, in its own frame, by at most `count` >= 1 directional lights that preserve
// its irradiance, for integrals of the map times something smoother. Splits the map like a median
// cut: always the box whose split lowers the variance most; each box becomes a light at its
// radiance-weighted center. A uniform sky is sampled evenly, a sun exactly at its place.
std::vector<DistantLight> distant_lights(const RadianceMap& map, std::size_t count);

// Lights are told apart that are 180 degrees / distant_light_rows apart.
inline constexpr int distant_light_rows = 64;

// A cluster of lights that a smooth function may sample at one direction.
struct LightGroup {
  DistantLight combined;
  std::vector<DistantLight> lights;
  int cluster = 0;  // index of the coarser cluster that contains it
};

struct LightGrouping {
  std::size_t groups = 1;
  // Maximum size of a group is 180 degrees / min_rows, which divides distant_light_rows; so there
  // may be more groups.
  int min_rows = 1;
  std::size_t clusters = 1;  // number of coarser clusters, <= groups
};

// Like distant_lights(), with the lights that each cluster combines.
std::vector<LightGroup> distant_light_groups(const RadianceMap& map, const LightGrouping& grouping);

}  // namespace brume
