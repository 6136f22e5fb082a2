#include "render/cpu/shadow_map.h"

#include <tbb/parallel_for.h>

namespace brume {

ShadowMap::ShadowMap(const Visibility& visibility, const glm::dvec3& light, const DirectionMap& map)
    : light_(light), map_(map) {
  if (visibility.empty()) return;
  distances_.resize(map.cells());
  tbb::parallel_for(0, map.rows + 2, [&](int y) {
    for (int x = 0; x < map.stride(); ++x) {
      distances_[static_cast<std::size_t>(y * map.stride() + x)] =
          static_cast<float>(visibility.first_hit(light, map.direction(x - 1, y - 1)).distance);
    }
  });
}

}  // namespace brume
