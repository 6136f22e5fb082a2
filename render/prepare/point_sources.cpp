#include "render/prepare/point_sources.h"

#include "render/prepare/light_limits.h"

namespace brume {

std::vector<PointSource> point_sources(std::span<const Light> lights, const CameraRays& rays,
                                       const Camera& camera, const FogBall& fog) {
  std::vector<PointSource> sources;
  sources.reserve(lights.size());
  for (const Light& light : lights) {
    sources.push_back({light.position, light.intensity,
                       min_light_distance(rays, camera, light.position), SpotFalloff(light.spot),
                       light.directional ? fog : FogBall{}, light.directional.has_value()});
  }
  return sources;
}

}  // namespace brume
