#include "render/prepare/point_sources.h"

#include <algorithm>

#include "render/prepare/light_limits.h"

namespace brume {

std::vector<PointSource> point_sources(std::span<const PointLight> lights, const CameraRays& rays,
                                       const Camera& camera, const FogExtent& extent) {
  std::vector<PointSource> sources;
  sources.reserve(lights.size());
  for (const PointLight& light : lights) {
    PointSource source{light, min_light_distance(rays, camera, light.position)};
    // A line along the axis of a disk gathers as much of its light as one so far from a point.
    source.h_min = std::max(source.h_min, 0.5 * light.radius);
    source.fog = light.is_far ? extent.ball() : extent.fog();
    sources.push_back(source);
  }
  return sources;
}

}  // namespace brume
