// Vertices at one place, and polygons that are there once more, against looking at all pairs.

#include "core/io/mesh/places.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/io/mesh/polygon_copies.h"
#include "tests/random.h"

namespace brume {
namespace {

using Index = std::uint32_t;

RawMesh random_mesh(Random& random) {
  const auto one_of = [&](int count) { return static_cast<int>(random.uniform(0.0, count)); };
  RawMesh mesh;
  const int places = 2 + one_of(4);
  const double signed_zero = -0.0;
  for (int i = 0; i < 30; ++i) {
    const double y = one_of(2) == 0 ? 0.0 : signed_zero;
    mesh.points.emplace_back(one_of(places), y, one_of(2));
  }
  for (int i = 0; i < 60; ++i) {
    std::vector<Index> corners(static_cast<std::size_t>(3 + one_of(2)));
    for (Index& corner : corners) corner = static_cast<Index>(one_of(30));
    add_polygon(mesh, corners);
  }
  return mesh;
}

TEST(Places, AreTheFirstPointsThere) {
  Random random(1);
  for (unsigned n = 0; n < random_cases(30); ++n) {
    const RawMesh mesh = random_mesh(random);
    const std::vector<Index> places = find_places(mesh.points);
    for (Index i = 0; i < mesh.points.size(); ++i) {
      const auto first = std::ranges::find(mesh.points, mesh.points[i]) - mesh.points.begin();
      ASSERT_EQ(places[i], static_cast<Index>(first));
    }
  }
}

// Whether b is a, begun at another corner, turned round or not.
bool are_alike(const std::vector<Index>& a, std::vector<Index> b) {
  if (a.size() != b.size()) return false;
  for (int side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (a == b) return true;
      std::ranges::rotate(b, b.begin() + 1);
    }
    std::ranges::reverse(b);
  }
  return false;
}

TEST(PolygonCopies, AreThoseOfTheFirstAlike) {
  Random random(2);
  std::size_t copy_count = 0;
  for (unsigned n = 0; n < random_cases(30); ++n) {
    const RawMesh mesh = random_mesh(random);
    const std::vector<Index> places = find_places(mesh.points);
    std::vector<std::vector<Index>> polygons;
    for (std::size_t begin = 0; const std::size_t end : mesh.polygon_ends) {
      std::vector<Index>& own = polygons.emplace_back();
      for (; begin < end; ++begin) own.push_back(places[mesh.corners[begin]]);
    }
    const PolygonCopies copies = find_copies(mesh, places);
    for (Index i = 0; i < polygons.size(); ++i) {
      std::vector<Index> different = polygons[i];
      std::ranges::sort(different);
      // The lowest place of one that passes it twice is no single start.
      if (std::ranges::adjacent_find(different) != different.end()) continue;
      const auto first = std::ranges::find_if(
          polygons, [&](const std::vector<Index>& other) { return are_alike(polygons[i], other); });
      ASSERT_EQ(copies.originals[i], static_cast<Index>(first - polygons.begin()));
      copy_count += copies.is_copy(i) ? 1 : 0;
    }
  }
  EXPECT_GT(copy_count, 0u);
}

}  // namespace
}  // namespace brume
