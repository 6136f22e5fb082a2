#pragma once

#include <vector>

#include "render/geometry/direction_map.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// A point is lit where this share of its distance from the light is no more than a shadow map's. A
// cell stands for its neighbourhood, where a slanting surface is nearer and farther by about the
// cells' width: so much behind the surface is still lit, or all surfaces would be darkened.
inline float shadow_share(const DirectionMap& map) {
  return 1.0f - 2.0f * static_cast<float>(map.cell_angle());
}

// Shadow map of a point light: distance to the first surface per direction, for shadows of surfaces
// in the medium (light shafts). Traced in parallel by Embree.
class ShadowMap {
 public:
  ShadowMap(const RayCaster& ray_caster, const glm::dvec3& light, const DirectionMap& map);

  [[nodiscard]] const glm::dvec3& light() const { return light_; }
  [[nodiscard]] const DirectionMap& map() const { return map_; }
  // No surfaces.
  [[nodiscard]] bool empty() const { return distances_.empty(); }
  // Rows of map().stride() distances [u], +inf where nothing is hit.
  [[nodiscard]] const float* distances() const { return distances_.data(); }
  // Minimum and maximum over each 2 x 2 footprint of bilinear interpolation.
  struct Range {
    float min_distance, max_distance;
  };
  [[nodiscard]] const Range* ranges() const { return ranges_.data(); }

 private:
  glm::dvec3 light_;
  DirectionMap map_;
  std::vector<float> distances_;
  std::vector<Range> ranges_;
};

}  // namespace brume
