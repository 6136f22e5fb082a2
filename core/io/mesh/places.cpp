#include "core/io/mesh/places.h"

#include <algorithm>
#include <bit>
#include <tuple>

#include "core/io/mesh/hashed_indices.h"

namespace brume {

std::vector<std::uint32_t> find_places(std::span<const glm::dvec3> points) {
  using Index = std::uint32_t;
  const auto key = [&](Index i) { return std::tie(points[i].x, points[i].y, points[i].z); };
  std::vector<Index> places(points.size());
  const auto hash = [&](Index i) {
    std::uint64_t mixed = 0;
    // The sum makes a 0 of -0.
    for (int axis = 0; axis < 3; ++axis) {
      mixed = mixed_bits(mixed + std::bit_cast<std::uint64_t>(points[i][axis] + 0.0));
    }
    return mixed;
  };
  for_each_alike(
      points.size(), hash, [&places](Index alone) { places[alone] = alone; },
      [&](std::span<Index> alike) {
        std::ranges::sort(alike, [&](Index a, Index b) {
          return key(a) < key(b) || (key(a) == key(b) && a < b);
        });
        Index first = alike.front();
        for (const Index i : alike) {
          if (key(i) != key(first)) first = i;
          places[i] = first;
        }
      });
  return places;
}

}  // namespace brume
