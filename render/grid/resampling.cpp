#include "render/grid/resampling.h"

#include <glm/common.hpp>

namespace brume {

std::array<float, 8> Resampling::Cell::weights() const {
  std::array<float, 8> weights{};
  for (int i = 0; i < 8; ++i) {
    const auto along = [&](int k) { return (i >> k & 1) != 0 ? place[k] : 1.0f - place[k]; };
    weights[static_cast<std::size_t>(i)] = along(0) * along(1) * along(2);
  }
  return weights;
}

Resampling::Resampling(const NodeLayout& source, const NodeLayout& target)
    : source_(source.nodes),
      target_(target.nodes),
      scale_(static_cast<double>(target.nodes.spacing) / static_cast<double>(source.nodes.spacing)),
      offset_((target.first - source.first) / static_cast<double>(source.nodes.spacing)) {}

Resampling::Cell Resampling::cell_of(const glm::ivec3& node) const {
  const glm::dvec3 last(source_.count - 1);
  const glm::dvec3 x = glm::clamp(offset_ + scale_ * glm::dvec3(node), glm::dvec3(0.0), last);
  const glm::ivec3 low = glm::min(glm::ivec3(x), source_.count - 2);
  return {node_index(source_, low), glm::vec3(x - glm::dvec3(low))};
}

std::array<std::size_t, 8> Resampling::corners() const {
  std::array<std::size_t, 8> corners{};
  for (int i = 0; i < 8; ++i) {
    corners[static_cast<std::size_t>(i)] = node_index(source_, {i & 1, i >> 1 & 1, i >> 2});
  }
  return corners;
}

void Resampling::apply(std::span<const float> values, std::span<float> result) const {
  const std::array<std::size_t, 8> all = corners();
  for (std::size_t i = 0; i < target_.size(); ++i) {
    const Cell cell = cell_of(node_coordinates(target_, i));
    const std::array<float, 8> weights = cell.weights();
    float sum = 0.0f;
    for (std::size_t k = 0; k < 8; ++k) sum += weights[k] * values[cell.first + all[k]];
    result[i] = sum;
  }
}

}  // namespace brume
