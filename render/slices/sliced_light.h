#pragma once

#include "render/geometry/point_source.h"
#include "render/optical_depth/optical_depth_table.h"
#include "render/slices/shadow_map.h"

namespace brume {

struct SlicedLight : PointSource {
  const OpticalDepthTable* table = nullptr;  // null without Gaussians
  const ShadowMap* shadows = nullptr;        // null without surfaces
};

}  // namespace brume
