#include "render/slices/shadow_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "render/geometry/rounding.h"

namespace brume {

ShadowMap::ShadowMap(const RayCaster& ray_caster, const glm::dvec3& light, const DirectionMap& map)
    : light_(light), map_(map) {
  if (ray_caster.empty()) return;
  start_ = shadow_start(map, light, ray_caster.center());
  depths_.resize(map.cells());
  const auto stride = static_cast<std::size_t>(map.stride());
  std::vector<std::vector<PaneHit>> panes(ray_caster.has_panes() ? map.cells() : 0);
  // A light on a ceiling shines.
  const double nearest = rounding_at(light - ray_caster.center());
  tbb::parallel_for(0, map.rows + 2, [&](int y) {
    std::vector<glm::dvec3> directions;
    directions.reserve(stride);
    for (int x = 0; x < map.stride(); ++x) directions.push_back(map.direction(x - 1, y - 1));
    std::vector<SurfaceHit> hits(stride);
    ray_caster.first_hits(light, directions, hits, nearest);
    const std::size_t first = static_cast<std::size_t>(y) * stride;
    for (std::size_t x = 0; x < stride; ++x) {
      if (ray_caster.is_pane(hits[x])) {
        HitsOnRay on_ray = ray_caster.hits_on_ray(light, directions[x], nearest);
        hits[x] = on_ray.end;
        panes[first + x] = std::move(on_ray.panes);
        for (PaneHit& pane : panes[first + x]) {
          pane.hit.distance = depth(directions[x], pane.hit.distance);
        }
      }
      depths_[first + x] = depth(directions[x], hits[x].distance);
    }
  });
  add_panes(panes);
  ranges_.resize(map.cells());
  for (std::size_t i = 0; i + stride + 1 < depths_.size(); ++i) {
    const auto [min_depth, max_depth] =
        std::minmax({depths_[i], depths_[i + 1], depths_[i + stride], depths_[i + stride + 1]});
    ranges_[i] = {min_depth, max_depth};
    if (panes_.empty()) continue;
    const std::vector<float>& first = panes_.front().depths;
    ranges_[i].min_depth =
        std::min({min_depth, first[i], first[i + 1], first[i + stride], first[i + stride + 1]});
  }
}

float ShadowMap::depth(const glm::dvec3& direction, double distance) const {
  const double cosine = map_.octahedral ? 1.0 : glm::dot(direction, glm::dvec3(map_.axis));
  return static_cast<float>(distance * cosine - start_);
}

void ShadowMap::add_panes(std::span<const std::vector<PaneHit>> panes) {
  std::size_t count = 0;
  for (const auto& each : panes) count = std::max(count, each.size());
  panes_.resize(std::min(count, max_pane_layers));
  for (PaneLayer& layer : panes_) {
    layer.depths.assign(panes.size(), std::numeric_limits<float>::infinity());
    layer.passing.assign(panes.size(), 1.0f);
  }
  for (std::size_t cell = 0; cell < panes.size(); ++cell) {
    for (std::size_t k = 0; k < panes[cell].size(); ++k) {
      PaneLayer& layer = panes_[std::min(k, max_pane_layers - 1)];
      if (k < max_pane_layers) {
        layer.depths[cell] = static_cast<float>(panes[cell][k].hit.distance);
      }
      layer.passing[cell] *= static_cast<float>(panes[cell][k].passing);
    }
  }
}

}  // namespace brume
