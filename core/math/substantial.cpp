#include "core/math/substantial.h"

#include <algorithm>
#include <functional>
#include <glm/common.hpp>
#include <iterator>
#include <numeric>

#include "core/math/infinity.h"

namespace brume {
namespace {

double longest_side(std::span<const GaussianExtent> gaussians,
                    std::span<const std::size_t> indices) {
  glm::dvec3 low(infinity);
  glm::dvec3 high(-infinity);
  for (const std::size_t i : indices) {
    low = glm::min(low, gaussians[i].low);
    high = glm::max(high, gaussians[i].high);
  }
  const glm::dvec3 sides = high - low;
  return std::max({sides.x, sides.y, sides.z});
}

}  // namespace

std::vector<std::size_t> substantial_gaussians(std::span<const GaussianExtent> gaussians) {
  constexpr double thin_depth = 0.01;
  double sum = 0.0;
  for (const GaussianExtent& g : gaussians) sum += g.depth;
  double open = thin_depth * std::min(sum, 1.0);
  std::vector<std::size_t> all(gaussians.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::size_t> thin;  // a heap, the thinnest first
  std::ranges::copy_if(all, std::back_inserter(thin), [&](std::size_t i) {
    return !gaussians[i].emits && gaussians[i].depth <= open;
  });
  const auto depth = [&](std::size_t i) { return gaussians[i].depth; };
  std::ranges::make_heap(thin, std::ranges::greater(), depth);
  std::vector<bool> counts(gaussians.size(), true);
  while (!thin.empty() && gaussians[thin.front()].depth <= open) {
    open -= gaussians[thin.front()].depth;
    counts[thin.front()] = false;
    std::ranges::pop_heap(thin, std::ranges::greater(), depth);
    thin.pop_back();
  }
  std::vector<std::size_t> thick;
  std::ranges::copy_if(all, std::back_inserter(thick), [&](std::size_t i) { return counts[i]; });
  const bool is_shorter = longest_side(gaussians, thick) <= 0.5 * longest_side(gaussians, all);
  return !thick.empty() && is_shorter ? thick : all;
}

}  // namespace brume
