#include "render/paths/path_medium.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "core/math/infinity.h"

namespace brume {
namespace {}  // namespace

PathMedium::PathMedium(const MediumIndex& medium) : medium_(medium) {
  std::vector<GaussianTerm<double>> gaussians;
  std::vector<double> cutoff_radii;
  for (const std::uint32_t i : spatial_order(medium)) {
    gaussians.push_back(medium.gaussians()[i]);
    cutoff_radii.push_back(medium.cutoff_radii()[i]);
    arrays_.add(gaussians.back(), cutoff_radii.back());
  }
  arrays_.finish();
  grid_ = MajorantGrid(gaussians, cutoff_radii, GaussianArrays::max_lanes);
}

// Along a Morton curve through the centers.
std::vector<std::uint32_t> PathMedium::spatial_order(const MediumIndex& medium) {
  glm::dvec3 low(infinity);
  glm::dvec3 high(-infinity);
  for (const GaussianTerm<double>& g : medium.gaussians()) {
    low = glm::min(low, g.b);
    high = glm::max(high, g.b);
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < medium.size(); ++i) {
    constexpr double cells = 1 << 16;
    const glm::dvec3 place = (medium.gaussians()[i].b - low) / glm::max(high - low, 1e-300);
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto cell =
          static_cast<std::uint64_t>(std::clamp(place[axis], 0.0, 1.0) * (cells - 1.0));
      for (unsigned bit = 0; bit < 16; ++bit) {
        key |= (cell >> bit & 1u) << (3 * bit + static_cast<unsigned>(axis));
      }
    }
    keys.emplace_back(key, i);
  }
  std::ranges::sort(keys);
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& [key, i] : keys) order.push_back(i);
  return order;
}

double PathMedium::density(const glm::dvec3& x) const {
  const std::span<const std::uint32_t> near = grid_.gaussians_at(x);
  return near.empty() ? 0.0 : arrays_.density(near, x);
}

double PathMedium::depth(const glm::dvec3& origin, const glm::dvec3& w, double length) const {
  if (grid_.empty() || !(length > 0.0)) return 0.0;
  // Past the far side of the grid nothing is left.
  const Box& box = grid_.bounds();
  const double far =
      glm::length(0.5 * (box.low + box.high) - origin) + glm::length(box.high - box.low);
  return arrays_.depth(origin, w, std::min(length, far));
}

double PathMedium::collision(const glm::dvec3& origin, const glm::dvec3& w, double length,
                             PathRandom& random) const {
  MajorantGrid::Walk walk(grid_, origin, w, length);
  double t = walk.enter();
  double depth = -std::log(random.uniform());
  int tentative = 0;
  while (walk.in_cell()) {
    const double majorant = walk.majorant();
    const double room = majorant * (walk.exit() - t);
    if (depth >= room) {
      depth -= room;
      walk.next();
      t = walk.enter();
      continue;
    }
    t += depth / majorant;
    if (random.uniform() * majorant < arrays_.density(walk.gaussians(), origin + t * w)) return t;
    if (++tentative == max_tentative) {
      return t + collision_by_depth(origin + t * w, w, length - t, random);
    }
    depth = -std::log(random.uniform());
  }
  return infinity;
}

double PathMedium::collision_by_depth(const glm::dvec3& origin, const glm::dvec3& w, double length,
                                      PathRandom& random) const {
  const double level = -std::log(random.uniform());
  const Box& box = grid_.bounds();
  double high = std::min(
      length, glm::length(0.5 * (box.low + box.high) - origin) + glm::length(box.high - box.low));
  if (!(depth(origin, w, high) > level)) return infinity;
  // Newton's method, bisecting where it leaves the bracket.
  double low = 0.0;
  double t = 0.5 * high;
  for (int k = 0; k < 100; ++k) {
    const double error = depth(origin, w, t) - level;
    if (std::abs(error) <= 1e-9 * level) break;
    (error < 0.0 ? low : high) = t;
    double next = t - error / density(origin + t * w);
    if (!(low < next && next < high)) next = 0.5 * (low + high);
    if (!(low < next && next < high)) break;
    t = next;
  }
  return t;
}

}  // namespace brume
