#pragma once

#include <vector>

#include "render/cpu/direction_map.h"
#include "render/cpu/visibility.h"

namespace brume {

// How far a light shines in every direction before a surface stops it: shadows of surfaces in the
// medium (light shafts). In parallel, by Embree.
class ShadowMap {
 public:
  ShadowMap(const Visibility& visibility, const glm::dvec3& light, const DirectionMap& map);

  [[nodiscard]] const glm::dvec3& light() const { return light_; }
  [[nodiscard]] const DirectionMap& map() const { return map_; }
  // Nothing stands around the light.
  [[nodiscard]] bool empty() const { return distances_.empty(); }
  // Rows of map().row() distances [u], +inf where nothing is hit.
  [[nodiscard]] const float* distances() const { return distances_.data(); }
  // The least and the greatest distance of each cell, the one right of it and the two below: what
  // is mixed for a direction between them.
  struct Range {
    float least, greatest;
  };
  [[nodiscard]] const Range* ranges() const { return ranges_.data(); }

 private:
  glm::dvec3 light_;
  DirectionMap map_;
  std::vector<float> distances_;
  std::vector<Range> ranges_;
};

}  // namespace brume
