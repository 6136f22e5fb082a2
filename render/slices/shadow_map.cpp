#include "render/slices/shadow_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

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
    ray_caster.opaque_hits(light, directions, hits, rounding_at(light - ray_caster.center()));
    float* const row = depths_.data() + static_cast<std::size_t>(y) * stride;
    for (std::size_t x = 0; x < stride; ++x) {
      row[x] = depth(directions[x], hits[x].distance);
    }
  });
  ranges_.resize(map.cells());
  for (std::size_t i = 0; i + stride + 1 < depths_.size(); ++i) {
    const auto [min_depth, max_depth] =
        std::minmax({depths_[i], depths_[i + 1], depths_[i + stride], depths_[i + stride + 1]});
    ranges_[i] = {min_depth, max_depth};
  }
  if (ray_caster.has_panes()) add_panes(ray_caster);
}

float ShadowMap::depth(const glm::dvec3& direction, double distance) const {
  const double cosine = map_.octahedral ? 1.0 : glm::dot(direction, glm::dvec3(map_.axis));
  return static_cast<float>(distance * cosine - start_);
}

void ShadowMap::add_panes(const RayCaster& ray_caster) {
  const auto stride = static_cast<std::size_t>(map_.stride());
  const double nearest = rounding_at(light_ - ray_caster.center());
  std::vector<std::vector<PaneHit>> panes(map_.cells());
  tbb::parallel_for(std::size_t{0}, panes.size(), [&](std::size_t cell) {
    const glm::dvec3 direction =
        map_.direction(static_cast<int>(cell % stride) - 1, static_cast<int>(cell / stride) - 1);
    panes[cell] = ray_caster.hits_on_ray(light_, direction, nearest).panes;
    for (PaneHit& pane : panes[cell]) pane.hit.distance = depth(direction, pane.hit.distance);
  });
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
