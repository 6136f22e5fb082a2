#include "core/scene/lights/environment.h"

#include <cassert>
#include <glm/trigonometric.hpp>

#include "core/scene/lights/radiance_map.h"

namespace brume {

glm::dquat environment_rotation(const Environment& environment) {
  return glm::angleAxis(glm::radians(environment.rotation), glm::dvec3(0.0, 1.0, 0.0));
}

glm::dvec3 environment_radiance(const Environment& environment, const glm::dvec3& direction) {
  assert(environment.map);
  const glm::dvec3 in_map = glm::conjugate(environment_rotation(environment)) * direction;
  return environment.intensity * map_radiance(*environment.map, in_map);
}

ShVector<glm::dvec3> environment_sh(const Environment& environment, int order) {
  assert(environment.map);
  ShVector<glm::dvec3> light =
      sh_rotate(map_sh(*environment.map, order), environment_rotation(environment));
  for (std::size_t i = 0; i < light.size(); ++i) light[i] *= environment.intensity;
  return light;
}

}  // namespace brume
