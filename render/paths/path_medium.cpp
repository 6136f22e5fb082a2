#include "render/paths/path_medium.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace brume {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

PathMedium::PathMedium(const MediumIndex& medium)
    : medium_(medium), grid_(medium.gaussians(), medium.cutoff_radii(), GaussianArrays::max_lanes) {
  for (std::size_t i = 0; i < medium.size(); ++i) {
    arrays_.add(medium.gaussians()[i], medium.cutoff_radii()[i]);
  }
  arrays_.pad();
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
  const double end = std::min(length, far);
  if (arrays_.size() <= max_unsorted) return arrays_.depth(origin, w, end);
  thread_local GaussianArrays touched;
  touched.clear();
  medium_.bvh().query(RaySegment{origin, w, end},
                      [&](std::uint32_t i) { touched.add(arrays_, i); });
  touched.pad();
  return touched.depth(origin, w, end);
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
  double low = 0.0;
  while (true) {
    const double center = 0.5 * (low + high);
    if (!(low < center && center < high)) return high;
    (depth(origin, w, center) < level ? low : high) = center;
  }
}

}  // namespace brume
