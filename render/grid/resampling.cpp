#include "render/grid/resampling.h"

#include <algorithm>
#include <glm/common.hpp>

namespace brume {

Resampling::Resampling(const glm::dvec3& from_first, const GridNodes& from, const glm::dvec3& first,
                       const GridNodes& nodes)
    : from_(from),
      nodes_(nodes),
      from_first_(from_first),
      first_(first),
      scale_(static_cast<double>(nodes.spacing) / static_cast<double>(from.spacing)),
      offset_((first - from_first) / static_cast<double>(from.spacing)) {}

Resampling::Cell Resampling::cell_of(const glm::ivec3& node) const {
  const glm::dvec3 last(from_.count - 1);
  const glm::dvec3 x = glm::clamp(offset_ + scale_ * glm::dvec3(node), glm::dvec3(0.0), last);
  const glm::ivec3 low = glm::min(glm::ivec3(x), from_.count - 2);
  return {node_index(from_, low), glm::vec3(x - glm::dvec3(low))};
}

std::array<std::size_t, 8> Resampling::corners() const {
  std::array<std::size_t, 8> corners{};
  for (int i = 0; i < 8; ++i) {
    corners[static_cast<std::size_t>(i)] = node_index(from_, {i & 1, i >> 1 & 1, i >> 2});
  }
  return corners;
}

float Resampling::interpolated(std::span<const float> values, const Cell& cell) const {
  const auto row = static_cast<std::size_t>(from_.count.x);
  const std::size_t slab = row * static_cast<std::size_t>(from_.count.y);
  const float* corner = values.data() + cell.first;
  const glm::vec3& f = cell.place;
  const auto edge = [&](std::size_t k) { return glm::mix(corner[k], corner[k + 1], f.x); };
  return glm::mix(glm::mix(edge(0), edge(row), f.y), glm::mix(edge(slab), edge(slab + row), f.y),
                  f.z);
}

float Resampling::seen(std::span<const float> values, const Cell& cell, std::uint8_t hidden) const {
  if (hidden == 0) return interpolated(values, cell);
  const std::array<std::size_t, 8> all = corners();
  float sum = 0.0f;
  float weights = 0.0f;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((hidden >> i & 1) != 0) continue;
    float weight = 1.0f;
    for (int k = 0; k < 3; ++k) weight *= (i >> k & 1) != 0 ? cell.place[k] : 1.0f - cell.place[k];
    sum += weight * values[cell.first + all[i]];
    weights += weight;
  }
  return weights > 0.0f ? sum / weights : 0.0f;
}

template <class Visit>
void Resampling::visit_border(int slab, Visit visit) const {
  const glm::ivec3 last = nodes_.count - 1;
  for (int y = 0; y <= last.y; ++y) {
    const bool is_whole_row = slab == 0 || slab == last.z || y == 0 || y == last.y;
    for (int x = 0; x <= last.x; x += is_whole_row ? 1 : last.x) {
      visit(node_index(nodes_, {x, y, slab}), glm::ivec3(x, y, slab));
    }
  }
}

void Resampling::see(const RayCaster& surfaces, std::span<const std::uint32_t> blocked,
                     const Job& job) {
  if (blocked.empty()) return;
  hidden_.assign(nodes_.size(), 0);
  const std::array<std::size_t, 8> all = corners();
  const auto place = [](const glm::dvec3& first, const GridNodes& nodes, std::size_t node) {
    return first + static_cast<double>(nodes.spacing) * glm::dvec3(node_coordinates(nodes, node));
  };
  job.parallel_for(static_cast<std::size_t>(nodes_.count.z), [&](std::size_t slab) {
    visit_border(static_cast<int>(slab), [&](std::size_t i, const glm::ivec3& node) {
      const std::size_t first = cell_of(node).first;
      const auto is_beside_surfaces = [&](std::size_t corner) {
        return blocked[first + corner] != 0;
      };
      if (std::ranges::none_of(all, is_beside_surfaces)) return;
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (surfaces.occluded(place(first_, nodes_, i),
                              place(from_first_, from_, first + all[k]))) {
          hidden_[i] |= static_cast<std::uint8_t>(1u << k);
        }
      }
    });
  });
}

void Resampling::apply(std::span<const float> values, std::span<float> result) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    result[i] = interpolated(values, cell_of(node_coordinates(nodes_, i)));
  }
}

void Resampling::apply_to_border(std::span<const float> values, std::span<float> result) const {
  for (int slab = 0; slab < nodes_.count.z; ++slab) {
    visit_border(slab, [&](std::size_t i, const glm::ivec3& node) {
      result[i] = seen(values, cell_of(node), hidden_.empty() ? std::uint8_t{0} : hidden_[i]);
    });
  }
}

}  // namespace brume
