#include "core/io/mesh/mesh_normals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <utility>

#include "core/io/mesh/places.h"
#include "core/math/normals.h"

namespace brume {
namespace {

using Index = std::uint32_t;

// Two triangles lie on each other if their normals are this close to opposite, about 8 degrees.
constexpr double cos_folded = -0.99;
// Beyond an edge of more than two triangles, those go on within this angle, 60 degrees.
constexpr double cos_continued = 0.5;

// Disjoint sets of triangles, each of which is turned against the first of its set or not.
class TurnedSets {
 public:
  explicit TurnedSets(std::size_t size) : parents_(size), turned_(size, false) {
    for (std::size_t i = 0; i < size; ++i) parents_[i] = static_cast<Index>(i);
  }

  // The first of the set, and whether the triangle is turned against it.
  std::pair<Index, bool> root(Index triangle) {
    Index first = triangle;
    bool is_turned = false;
    for (; parents_[first] != first; first = parents_[first]) {
      is_turned = is_turned != turned_[first];
    }
    // The way there becomes a step.
    for (bool rest = is_turned; parents_[triangle] != first && triangle != first;) {
      const Index next = std::exchange(parents_[triangle], first);
      const bool step = turned_[triangle];
      turned_[triangle] = rest;
      rest = rest != step;
      triangle = next;
    }
    return {first, is_turned};
  }

  // Without effect where they are in one set.
  void join(Index a, Index b, bool is_turned) {
    auto [first, a_turned] = root(a);
    auto [second, b_turned] = root(b);
    if (first == second) return;
    if (second < first) std::swap(first, second);
    parents_[second] = first;
    turned_[second] = is_turned != (a_turned != b_turned);
  }

 private:
  std::vector<Index> parents_;
  std::vector<bool> turned_;  // against the parent
};

// An edge of a triangle, from a place to a higher one.
struct Edge {
  Index high;
  Index triangle : 31;
  Index is_forward : 1;  // the triangle goes from low to high

  bool operator<(const Edge& other) const {
    return high != other.high ? high < other.high : triangle < other.triangle;
  }
};
static_assert(sizeof(Edge) == 8);

// The edges of all triangles by their lower place: those of place p are edges[ends[p - 1]] to
// edges[ends[p]].
struct EdgesByPlace {
  std::vector<Edge> edges;
  std::vector<std::size_t> ends;
};

EdgesByPlace edges_by_place(std::span<const Index> places, const std::vector<bool>& ignored,
                            std::span<const glm::uvec3> triangles) {
  const auto visit_all = [&](auto&& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (ignored[t]) continue;
      for (int k = 0; k < 3; ++k) {
        const Index a = places[triangles[t][k]];
        const Index b = places[triangles[t][(k + 1) % 3]];
        if (a != b) visit(std::min(a, b), Edge{std::max(a, b), static_cast<Index>(t), a < b});
      }
    }
  };
  EdgesByPlace result;
  result.ends.resize(places.size() + 1);
  visit_all([&result](Index low, const Edge&) { ++result.ends[low + 1]; });
  std::partial_sum(result.ends.begin(), result.ends.end(), result.ends.begin());
  result.edges.resize(result.ends.back());
  // Each list's first becomes its end as it is filled.
  visit_all([&result](Index low, const Edge& edge) { result.edges[result.ends[low]++] = edge; });
  result.ends.pop_back();
  return result;
}

// Calls visit(edges) for all that are between two places, in order.
void for_each_edge(std::span<const Edge> edges_of_place, auto&& visit) {
  for (std::size_t i = 0; i < edges_of_place.size();) {
    const std::size_t begin = i;
    while (i < edges_of_place.size() && edges_of_place[i].high == edges_of_place[begin].high) ++i;
    visit(edges_of_place.subspan(begin, i - begin));
  }
}

// Turns triangles round so that all that hang together by edges are wound alike, as most of them
// are (of half and half, as the first is). Triangles that lie on each other, and those beyond an
// edge of more than two, are turned to one side. `points` of the vertices; vertices with the same
// number in `places` are at one place. `ignored` triangles keep their winding.
void make_winding_consistent(const std::vector<glm::dvec3>& points, std::span<const Index> places,
                             const std::vector<bool>& ignored, std::span<glm::uvec3> triangles) {
  const auto area = [&](Index t) { return area_normal(points, triangles[t]); };
  const auto normal = [&](Index t) { return unit_or_zero(area(t)); };
  // Most triangles are clearly not folded: no unit vectors are needed to see it.
  const auto is_folded = [&](Index a, Index b, bool is_turned) {
    constexpr double clear = 1e-200;  // no square underflows or overflows to it
    const double along = (is_turned ? -1.0 : 1.0) * glm::dot(area(a), area(b));
    if (along > clear && std::isfinite(along)) return false;
    const double cosine = glm::dot(normal(a), normal(b));
    return !((is_turned ? -cosine : cosine) > cos_folded);
  };
  auto [edges, ends] = edges_by_place(places, ignored, triangles);
  const auto edges_of = [&edges = edges, &ends = ends](std::size_t place) {
    const std::size_t begin = place > 0 ? ends[place - 1] : 0;
    return std::span(edges).subspan(begin, ends[place] - begin);
  };
  // Most meshes are wound alike already.
  std::atomic<bool> is_consistent = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, ends.size(), 1024), [&](const auto& range) {
    for (std::size_t place = range.begin(); place < range.end(); ++place) {
      const std::span<Edge> own = edges_of(place);
      std::sort(own.begin(), own.end());
      for_each_edge(own, [&](std::span<const Edge> edge) {
        if (edge.size() == 1 || !is_consistent) return;
        if (edge.size() > 2 || edge[0].is_forward == edge[1].is_forward ||
            is_folded(edge[0].triangle, edge[1].triangle, false)) {
          is_consistent = false;
        }
      });
    }
  });
  if (is_consistent) return;
  TurnedSets sets(triangles.size());
  std::vector<std::pair<Index, Index>> overlaps;  // and what goes on beyond an edge of several
  for (std::size_t place = 0; place < ends.size(); ++place) {
    for_each_edge(edges_of(place), [&](std::span<const Edge> edge) {
      const Edge& first = edge.front();
      const bool has_two = edge.size() == 2;
      for (const Edge& other : edge.subspan(1)) {
        const bool is_turned = first.is_forward == other.is_forward;
        if (has_two && !is_folded(first.triangle, other.triangle, is_turned)) {
          sets.join(first.triangle, other.triangle, is_turned);
        } else if (has_two || std::abs(glm::dot(normal(first.triangle), normal(other.triangle))) >
                                  cos_continued) {
          overlaps.emplace_back(first.triangle, other.triangle);
        }
      }
    });
  }
  edges = {};
  for (const auto& [a, b] : overlaps) sets.join(a, b, glm::dot(normal(a), normal(b)) < 0.0);

  std::vector<std::int64_t> turned_less_others(triangles.size(), 0);  // by the first of each set
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto [first, is_turned] = sets.root(t);
    turned_less_others[first] += is_turned ? 1 : -1;
  }
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto [first, is_turned] = sets.root(t);
    const bool most_are_turned = turned_less_others[first] > 0;
    if (is_turned != most_are_turned) std::swap(triangles[t].y, triangles[t].z);
  }
}

using Index = std::uint32_t;

// Vertices at one place are the seam of a smooth surface if their normals differ by less than 60
// degrees (patches tessellated one by one), else an edge that is meant to be seen.
constexpr double cos_seam = 0.5;

// Adds to every vertex's sum those of the vertices at the same place that it forms a seam with.
void smooth_seams(const RawMesh& raw, std::span<const Index> places,
                  std::vector<glm::dvec3>& sums) {
  std::vector<bool> is_shared(sums.size());
  for (Index i = 0; i < places.size(); ++i) {
    if (places[i] != i) is_shared[places[i]] = is_shared[i] = true;
  }
  std::vector<Index> order;
  for (Index i = 0; i < places.size(); ++i) {
    if (is_shared[i]) order.push_back(i);
  }
  const auto place = [&](Index i) { return places[i]; };
  std::ranges::stable_sort(order, {}, place);
  // A place where very many vertices meet is no seam, and pairs would take long.
  constexpr std::ptrdiff_t limit = 64;
  std::vector<glm::dvec3> own;  // the sums at a place, before
  for (auto first = order.begin(); first != order.end();) {
    const auto last =
        std::find_if(first, order.end(), [&](Index i) { return place(i) != place(*first); });
    own.clear();
    for (auto i = first; last - first <= limit && i != last; ++i) own.push_back(sums[*i]);
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (std::size_t j = 0; j < own.size(); ++j) {
        if (i == j) continue;
        const Index a = *(first + static_cast<std::ptrdiff_t>(i));
        const Index b = *(first + static_cast<std::ptrdiff_t>(j));
        const bool is_split = !raw.file_points.empty() && raw.file_points[a] == raw.file_points[b];
        const double cosine = glm::dot(unit_or_zero(own[i]), unit_or_zero(own[j]));
        if (is_split || cosine > cos_seam) sums[a] += own[j];
      }
    }
    first = last;
  }
}

// Adds what each triangle says of its vertices.
void add_areas(const RawMesh& raw, const Triangulation& faces, const std::vector<bool>& ignored,
               std::vector<glm::dvec3>& sums) {
  for (std::size_t t = 0; t < faces.triangles.size(); ++t) {
    if (ignored[t]) continue;
    const glm::dvec3 area = area_normal(raw.points, faces.triangles[t]);
    for (int k = 0; k < 3; ++k) sums[faces.triangles[t][k]] += area;
  }
}

// Normals for a mesh without any.
std::vector<glm::dvec3> smooth_normals(RawMesh& raw, Triangulation& faces) {
  const std::vector<Index> places = find_places(raw.points);
  PolygonCopies copies = find_copies(raw, places);
  cut_alike(raw, places, copies, faces);
  std::vector<bool> ignored;
  for (const Index polygon : faces.polygons) ignored.push_back(copies.is_copy(polygon));
  // Large meshes need the memory.
  raw.corners = {};
  raw.polygon_ends = {};
  faces.polygons = {};
  copies.originals = {};
  make_winding_consistent(raw.points, places, ignored, faces.triangles);
  std::vector<glm::dvec3> sums(raw.points.size(), glm::dvec3(0.0));
  add_areas(raw, faces, ignored, sums);
  smooth_seams(raw, places, sums);
  for (const auto& [copy, original] : copies.vertices) {
    if (sums[copy] == glm::dvec3(0.0)) sums[copy] = sums[original];
  }
  std::ranges::transform(sums, sums.begin(), unit_or_zero);
  return sums;
}

}  // namespace

std::vector<glm::dvec3> vertex_normals(RawMesh& raw, Triangulation& faces) {
  std::vector<glm::dvec3> normals(raw.normals.size());
  std::ranges::transform(raw.normals, normals.begin(), unit_or_zero);
  const glm::dvec3 none(0.0);
  const auto missing = std::ranges::count(normals, none);
  if (missing == std::ssize(normals)) return smooth_normals(raw, faces);
  if (missing == 0) return normals;
  std::vector<glm::dvec3> sums(raw.points.size(), none);
  add_areas(raw, faces, std::vector<bool>(faces.triangles.size(), false), sums);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (normals[i] == none) normals[i] = unit_or_zero(sums[i]);
  }
  return normals;
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double max_component = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(max_component > 0.0 && max_component <= 1e300)) return glm::dvec3(0.0);
  const glm::dvec3 scaled = v / max_component;  // so that no square underflows
  return scaled / glm::length(scaled);
}

}  // namespace brume
