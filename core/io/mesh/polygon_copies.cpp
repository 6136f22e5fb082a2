#include "core/io/mesh/polygon_copies.h"

#include <algorithm>
#include <numeric>
#include <ranges>

namespace brume {
namespace {

using Index = std::uint32_t;

std::span<const Index> polygon(const RawMesh& mesh, const std::vector<Index>& corners,
                               std::size_t i) {
  const std::size_t begin = i > 0 ? mesh.polygon_ends[i - 1] : 0;
  return std::span(corners).subspan(begin, mesh.polygon_ends[i] - begin);
}

}  // namespace

PolygonCopies find_copies(const RawMesh& mesh, std::span<const Index> places) {
  const std::size_t count = mesh.polygon_ends.size();
  const auto place = [&](Index vertex) { return places[vertex]; };
  PolygonCopies copies;
  copies.is_turned.resize(count);
  // Each polygon from its lowest place on, in the sense in which the next place is lower.
  std::vector<Index> canonical;
  canonical.reserve(mesh.corners.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto corners = polygon(mesh, mesh.corners, i);
    const auto begin = canonical.insert(canonical.end(), corners.begin(), corners.end());
    std::rotate(begin, std::ranges::min_element(begin, canonical.end(), {}, place),
                canonical.end());
    copies.is_turned[i] = place(canonical.back()) < place(*(begin + 1));
    if (copies.is_turned[i]) std::reverse(begin + 1, canonical.end());
  }
  const auto is_before = [&](Index a, Index b) {
    return std::ranges::lexicographical_compare(polygon(mesh, canonical, a),
                                                polygon(mesh, canonical, b), {}, place, place);
  };
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  copies.originals = order;
  std::ranges::stable_sort(order, is_before);
  for (std::size_t k = 1, first = 0; k < count; ++k) {
    const Index original = order[first];
    const Index copy = order[k];
    if (is_before(original, copy)) {
      first = k;
      continue;
    }
    copies.originals[copy] = original;
    const auto originals = polygon(mesh, canonical, original);
    const auto copied = polygon(mesh, canonical, copy);
    for (std::size_t c = 0; c < copied.size(); ++c) {
      if (copied[c] != originals[c]) copies.vertices.emplace_back(copied[c], originals[c]);
    }
  }
  // From the last on: originals stand before their copies, and are not turned against themselves.
  for (std::size_t i = count; i-- > 0;) {
    copies.is_turned[i] = copies.is_turned[i] != copies.is_turned[copies.originals[i]];
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
