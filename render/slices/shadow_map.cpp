#include "render/slices/shadow_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "render/geometry/rounding.h"

namespace brume {

ShadowMap::ShadowMap(const RayCaster& ray_caster, const glm::dvec3& light, const DirectionMap& map)
    : light_(light), map_(map) {
  if (ray_caster.empty()) return;
  start_ = shadow_start(map, light, ray_caster.center());
  depths_.resize(map.cells());
  const auto stride = static_cast<std::size_t>(map.stride());
  tbb::parallel_for(0, map.rows + 2, [&](int y) {
    std::vector<glm::dvec3> directions;
    directions.reserve(stride);
    for (int x = 0; x < map.stride(); ++x) directions.push_back(map.direction(x - 1, y - 1));
    std::vector<SurfaceHit> hits(stride);
    // A light on a ceiling shines.
    ray_caster.first_hits(light, directions, hits, rounding_at(light - ray_caster.center()));
    float* const row = depths_.data() + static_cast<std::size_t>(y) * stride;
    for (std::size_t x = 0; x < stride; ++x) {
      const double cosine = map.octahedral ? 1.0 : glm::dot(directions[x], glm::dvec3(map.axis));
      row[x] = static_cast<float>(hits[x].distance * cosine - start_);
    }
  });
  ranges_.resize(map.cells());
  for (std::size_t i = 0; i + stride + 1 < depths_.size(); ++i) {
    const auto [min_depth, max_depth] =
        std::minmax({depths_[i], depths_[i + 1], depths_[i + stride], depths_[i + stride + 1]});
    ranges_[i] = {min_depth, max_depth};
  }
}

}  // namespace brume
