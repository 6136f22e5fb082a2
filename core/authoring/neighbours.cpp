#include "core/authoring/neighbours.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/medium/gaussian_term.h"

namespace brume {
namespace {

// How far a Gaussian reaches along a unit direction [u].
double reach(const Medium& medium, std::size_t index, const glm::dvec3& direction) {
  return medium.radii()[index] * Ellipsoid<double>(medium.shape(index)).reach(direction);
}

}  // namespace

std::vector<GaussianId> touching(const Medium& medium, std::span<const GaussianId> ids) {
  // Sorted by the minimum x of their spheres: a sphere touches only those that begin before its end
  // and within the maximum diameter before its start.
  std::vector<std::size_t> order(medium.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto begin_of = [&](std::size_t i) { return medium.centers()[i].x - medium.radii()[i]; };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return begin_of(a) < begin_of(b); });
  double max_radius = 0.0;
  for (const double radius : medium.radii()) max_radius = std::max(max_radius, radius);

  std::vector<bool> touched(medium.size(), false);
  for (const GaussianId id : ids) {
    const std::size_t i = *medium.index_of(id);
    const double first = begin_of(i) - 2.0 * max_radius;
    const double last = medium.centers()[i].x + medium.radii()[i];
    auto it = std::lower_bound(order.begin(), order.end(), first,
                               [&](std::size_t k, double x) { return begin_of(k) < x; });
    for (; it != order.end() && begin_of(*it) <= last; ++it) {
      const glm::dvec3 way = medium.centers()[*it] - medium.centers()[i];
      const double distance = glm::length(way);
      if (distance > medium.radii()[i] + medium.radii()[*it]) continue;
      touched[*it] =
          touched[*it] || medium.shapes().empty() || distance == 0.0 ||
          distance <= reach(medium, i, way / distance) + reach(medium, *it, way / distance);
    }
  }
  std::vector<GaussianId> result;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (touched[i]) result.push_back(medium.ids()[i]);
  }
  return result;
}

}  // namespace brume
