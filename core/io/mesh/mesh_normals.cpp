#include "core/io/mesh/mesh_normals.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/io/mesh/places.h"
#include "core/io/mesh/polygon_copies.h"
#include "core/io/mesh/winding.h"
#include "core/math/normals.h"

namespace brume {
namespace {

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
