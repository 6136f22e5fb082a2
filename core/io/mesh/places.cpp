#include "core/io/mesh/places.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <ranges>
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

namespace {

using Index = std::uint32_t;

std::span<const Index> polygon(const RawMesh& mesh, const std::vector<Index>& corners,
                               std::size_t i) {
  const std::size_t begin = i > 0 ? mesh.polygon_ends[i - 1] : 0;
  return std::span(corners).subspan(begin, mesh.polygon_ends[i] - begin);
}

// Polygons that may be copies or have some: those whose places, in any order, share a hash.
std::vector<Index> find_candidates(const RawMesh& mesh, std::span<const Index> places) {
  std::vector<Index> candidates;
  const auto hash = [&](Index i) {
    std::uint64_t sum = 0;  // whatever the order
    for (const Index vertex : polygon(mesh, mesh.corners, i)) sum += mixed_bits(places[vertex]);
    return mixed_bits(sum);
  };
  for_each_alike(
      mesh.polygon_ends.size(), hash, [](Index) {},
      [&candidates](std::span<const Index> alike) {
        candidates.insert(candidates.end(), alike.begin(), alike.end());
      });
  std::ranges::sort(candidates);
  return candidates;
}

}  // namespace

PolygonCopies find_copies(const RawMesh& mesh, std::span<const Index> places) {
  const std::size_t count = mesh.polygon_ends.size();
  const auto place = [&](Index vertex) { return places[vertex]; };
  PolygonCopies copies;
  copies.is_turned.resize(count);
  copies.originals.resize(count);
  std::iota(copies.originals.begin(), copies.originals.end(), Index{0});
  const std::vector<Index> candidates = find_candidates(mesh, places);
  // Each candidate from its lowest place on, in the sense in which the next place is lower.
  std::vector<Index> canonical;
  std::vector<std::size_t> begins{0};
  std::vector<bool> is_turned;
  for (const Index i : candidates) {
    const auto corners = polygon(mesh, mesh.corners, i);
    const auto begin = canonical.insert(canonical.end(), corners.begin(), corners.end());
    std::rotate(begin, std::ranges::min_element(begin, canonical.end(), {}, place),
                canonical.end());
    is_turned.push_back(place(canonical.back()) < place(*(begin + 1)));
    if (is_turned.back()) std::reverse(begin + 1, canonical.end());
    begins.push_back(canonical.size());
  }
  const auto outline = [&](Index candidate) {
    return std::span(canonical).subspan(begins[candidate],
                                        begins[candidate + 1] - begins[candidate]);
  };
  const auto is_before = [&](Index a, Index b) {
    return std::ranges::lexicographical_compare(outline(a), outline(b), {}, place, place);
  };
  std::vector<Index> order(candidates.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, is_before);
  for (std::size_t k = 1, first = 0; k < order.size(); ++k) {
    const Index original = order[first];
    const Index copy = order[k];
    if (is_before(original, copy)) {
      first = k;
      continue;
    }
    copies.originals[candidates[copy]] = candidates[original];
    copies.is_turned[candidates[copy]] = is_turned[copy] != is_turned[original];
    const auto originals = outline(original);
    const auto copied = outline(copy);
    for (std::size_t c = 0; c < copied.size(); ++c) {
      if (copied[c] != originals[c]) copies.vertices.emplace_back(copied[c], originals[c]);
    }
  }
  return copies;
}

void cut_alike(const RawMesh& mesh, std::span<const Index> places, const PolygonCopies& copies,
               Triangulation& faces) {
  const auto count = static_cast<Index>(mesh.polygon_ends.size());
  const auto is_copy = [&](Index i) { return copies.is_copy(i); };
  if (std::ranges::none_of(std::views::iota(Index{0}, count), is_copy)) return;
  std::vector<std::size_t> ends(count, 0);  // of each polygon's triangles
  for (const Index i : faces.polygons) ++ends[i];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Index> vertex_at(places.size());  // of a copy, by place
  Triangulation alike;
  for (Index i = 0; i < count; ++i) {
    const Index original = copies.originals[i];
    if (is_copy(i)) {
      for (const Index vertex : polygon(mesh, mesh.corners, i)) vertex_at[places[vertex]] = vertex;
    }
    for (std::size_t t = original > 0 ? ends[original - 1] : 0; t < ends[original]; ++t) {
      glm::uvec3 triangle = faces.triangles[t];
      for (int k = 0; k < 3 && is_copy(i); ++k) triangle[k] = vertex_at[places[triangle[k]]];
      if (copies.is_turned[i]) std::swap(triangle.y, triangle.z);
      alike.triangles.push_back(triangle);
      alike.polygons.push_back(i);
    }
  }
  faces = std::move(alike);
}

}  // namespace brume
