#include "core/volume/block_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <optional>

#include "core/math/max_component.h"

namespace brume {
namespace {

// Where a line is inside a box.
std::optional<BlockTree::Interval> inside(const glm::dvec3& low, const glm::dvec3& high,
                                          const glm::dvec3& p, const glm::dvec3& w) {
  BlockTree::Interval found{-std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::infinity()};
  for (int k = 0; k < 3; ++k) {
    if (w[k] == 0.0) {
      if (p[k] < low[k] || p[k] > high[k]) return std::nullopt;
      continue;
    }
    const double a = (low[k] - p[k]) / w[k];
    const double b = (high[k] - p[k]) / w[k];
    found.begin = std::max(found.begin, std::min(a, b));
    found.end = std::min(found.end, std::max(a, b));
  }
  if (found.begin > found.end) return std::nullopt;
  return found;
}

}  // namespace

BlockTree::BlockTree(std::span<const DensityGrid::Block> blocks) {
  for (const DensityGrid::Block& block : blocks) corners_.push_back(block.corner);
  if (!corners_.empty()) split(0, corners_.size());
}

// Halves them across their longest side.
void BlockTree::split(std::size_t first, std::size_t count) {
  constexpr std::size_t max_leaf = 4;
  const std::size_t node = nodes_.size();
  const auto begin = corners_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  glm::ivec3 low = *begin;
  glm::ivec3 high = *begin;
  for (auto corner = begin; corner != end; ++corner) {
    low = glm::min(low, *corner);
    high = glm::max(high, *corner);
  }
  nodes_.push_back({low, high, first, count});
  if (count <= max_leaf) return;
  const glm::dvec3 extent(glm::dvec3(high) - glm::dvec3(low));
  int axis = 0;
  while (extent[axis] < max_component(extent)) ++axis;
  const std::size_t half = count / 2;
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half), end,
                   [axis](const glm::ivec3& a, const glm::ivec3& b) { return a[axis] < b[axis]; });
  split(first, half);
  nodes_[node].second = nodes_.size();
  split(first + half, count - half);
}

std::vector<BlockTree::Interval> BlockTree::intervals(const glm::dvec3& p,
                                                      const glm::dvec3& w) const {
  std::vector<Interval> found;
  // The density falls to 0 within a voxel around a block.
  const auto clip = [&](const glm::ivec3& low, const glm::ivec3& high) {
    return inside(glm::dvec3(low) - 1.0, glm::dvec3(high) + double(DensityGrid::side), p, w);
  };
  std::vector<std::size_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::size_t index = open.back();
    open.pop_back();
    const Node& node = nodes_[index];
    if (!clip(node.low, node.high)) continue;
    if (node.second != 0) {
      open.push_back(index + 1);
      open.push_back(node.second);
      continue;
    }
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      if (const auto interval = clip(corners_[i], corners_[i])) found.push_back(*interval);
    }
  }
  std::ranges::sort(found, {}, &Interval::begin);
  std::vector<Interval> joined;
  for (const Interval& interval : found) {
    if (joined.empty() || interval.begin > joined.back().end) {
      joined.push_back(interval);
    } else {
      joined.back().end = std::max(joined.back().end, interval.end);
    }
  }
  return joined;
}

}  // namespace brume
