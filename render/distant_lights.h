#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/radiance_map.h"

namespace brume {

// A part of an environment as light from one direction.
struct DistantLight {
  glm::dvec3 direction;  // towards it, unit
  glm::dvec3 flux;       // RGB: radiance times solid angle [W/u^2]
};

// A map in its own frame as at most `count` >= 1 lights, for integrals over the sphere of the map
// times something smoother. Boxes of the map are split where that lowers the spread of the light
// within boxes most, until there are enough; each becomes a light at the middle of its radiance. So
// an even sky is taken at even steps, a sun exactly where it stands, and all the light is there.
std::vector<DistantLight> distant_lights(const RadianceMap& map, std::size_t count);

// Some of the lights of a map that a smooth function may take at one direction.
struct LightGroup {
  DistantLight whole;
  std::vector<DistantLight> parts;  // in steps of 180 degrees / 64
  int family = 0;                   // of the coarser grouping, that holds it
};

struct LightGrouping {
  std::size_t groups = 1;
  // None is larger than 180 degrees / least_rows, which divides 64; so there may be more.
  int least_rows = 1;
  std::size_t families = 1;  // <= groups: of so many, when these were split on
};

// The same lights as distant_lights(), with what they are made of.
std::vector<LightGroup> distant_light_groups(const RadianceMap& map, const LightGrouping& grouping);

// The same in rows and columns of equal angles, `rows` >= 1 of them from pole to pole and twice as
// many around.
std::vector<DistantLight> even_distant_lights(const RadianceMap& map, int rows);

}  // namespace brume
