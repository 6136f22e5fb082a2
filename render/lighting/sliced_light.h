#pragma once

#include <glm/vec3.hpp>

#include "core/transport/spot_falloff.h"
#include "render/lighting/optical_depth_table.h"
#include "render/lighting/shadow_map.h"

namespace brume {

struct SlicedLight {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};                 // RGB [W/sr]
  double h_min = 0.0;                        // see light_limits.h [u]
  const OpticalDepthTable* table = nullptr;  // null without Gaussians
  const ShadowMap* shadows = nullptr;        // null without surfaces
  SpotFalloff spot{};
};

}  // namespace brume
