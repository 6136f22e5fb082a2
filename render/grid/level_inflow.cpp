#include "render/grid/level_inflow.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace brume {
namespace {

glm::dvec3 position(const NodeLayout& layout, std::size_t node) {
  return layout.first + static_cast<double>(layout.nodes.spacing) *
                            glm::dvec3(node_coordinates(layout.nodes, node));
}

}  // namespace

LevelInflow::LevelInflow(const NodeLayout& coarse, const NodeLayout& level)
    : coarse_(coarse), level_(level), resampling_(coarse, level) {
  const glm::ivec3 last = level.nodes.count - 1;
  for (std::size_t i = 0; i < level.nodes.size(); ++i) {
    const glm::ivec3 p = node_coordinates(level.nodes, i);
    if (glm::any(glm::equal(p, glm::ivec3(0))) || glm::any(glm::equal(p, last))) {
      border_.push_back({i, resampling_.cell_of(p), 0});
    }
  }
}

void LevelInflow::see(const RayCaster& surfaces, std::span<const std::uint32_t> blocked,
                      const Job& job) {
  if (blocked.empty()) return;
  const std::array<std::size_t, 8> corners = resampling_.corners();
  job.parallel_for(border_.size(), [&](std::size_t i) {
    BorderNode& node = border_[i];
    const auto is_beside_surfaces = [&](std::size_t corner) {
      return blocked[node.cell.first + corner] != 0;
    };
    if (std::ranges::none_of(corners, is_beside_surfaces)) return;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (surfaces.occluded(position(level_, node.index),
                            position(coarse_, node.cell.first + corners[k]))) {
        node.hidden |= static_cast<std::uint8_t>(1u << k);
      }
    }
  });
}

void LevelInflow::apply(std::span<const float> around, std::span<float> inflow) const {
  constexpr float min_weight = 1e-4f;  // all that is seen may be corners of no weight
  const std::array<std::size_t, 8> corners = resampling_.corners();
  for (const BorderNode& node : border_) {
    const std::array<float, 8> weights = node.cell.weights();
    float sum = 0.0f;
    float seen = 0.0f;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if ((node.hidden >> k & 1) != 0) continue;
      const float weight = std::max(weights[k], min_weight);
      sum += weight * around[node.cell.first + corners[k]];
      seen += weight;
    }
    inflow[node.index] = seen > 0.0f ? sum / seen : 0.0f;
  }
}

}  // namespace brume
