#include "render/cpu/shadow_map.h"

#include <tbb/parallel_for.h>

namespace brume {

ShadowMap::ShadowMap(const Visibility& visibility, const glm::dvec3& light, const DirectionMap& map)
    : light_(light), map_(map) {
  if (visibility.empty()) return;
  const int row = map.row();
  distances_.resize(static_cast<std::size_t>(row) * static_cast<std::size_t>(row));
  tbb::parallel_for(0, row, [&](int y) {
    for (int x = 0; x < row; ++x) {
      distances_[static_cast<std::size_t>(y * row + x)] =
          static_cast<float>(visibility.first_hit(light, map.direction(x - 1, y - 1)).distance);
    }
  });
}

}  // namespace brume
