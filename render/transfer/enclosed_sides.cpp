#include "render/transfer/enclosed_sides.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>
#include <tuple>

#include "brume/mesh_arrays.h"

namespace brume {
namespace {

using Index = std::uint32_t;

// Vertices within this share of the mesh's size are at the same place: the poles of tessellated
// balls differ by roundings.
constexpr double same_place = 1e-6;

// The relative rounding of a sum of volumes.
constexpr double rounding = 1e-12;

// For each vertex the first one at the same place.
std::vector<Index> places(const MeshArrays& mesh) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (const glm::vec3& p : mesh.points) {
    low = glm::min(low, glm::dvec3(p));
    high = glm::max(high, glm::dvec3(p));
  }
  const double size = std::max(glm::length(high - low), std::numeric_limits<double>::min());
  std::vector<std::tuple<glm::i64vec3, Index>> order;
  for (const glm::vec3& p : mesh.points) {
    const glm::dvec3 cell = (glm::dvec3(p) - 0.5 * (low + high)) / (same_place * size);
    order.emplace_back(glm::i64vec3(glm::round(cell)), static_cast<Index>(order.size()));
  }
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    const auto& [p, i] = a;
    const auto& [q, j] = b;
    return std::tie(p.x, p.y, p.z, i) < std::tie(q.x, q.y, q.z, j);
  });
  std::vector<Index> result(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& [cell, i] = order[k];
    const bool same = k > 0 && cell == std::get<0>(order[k - 1]);
    result[i] = same ? result[std::get<1>(order[k - 1])] : i;
  }
  return result;
}

// Disjoint sets of vertices, each named by one of them.
class Components {
 public:
  explicit Components(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), Index{0});
  }
  Index root(Index i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(Index a, Index b) { parents_[root(a)] = root(b); }

 private:
  std::vector<Index> parents_;
};

struct Edge {
  Index low, high;
  int sense;  // +1 from low to high, -1 back
};

struct Shape {
  double volume = 0.0;   // six times it, > 0 if the winding is outward
  double volumes = 0.0;  // the sum of what each triangle adds or takes
  double normals = 0.0;  // < 0 if vertex normals go against the winding
  bool closed = true;
};

}  // namespace

std::vector<Enclosed> enclosed_sides(const TriangleMesh& of) {
  const MeshArrays& mesh = to_arrays(of);
  const std::vector<Index> place = places(mesh);
  Components components(place.size());
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const glm::uvec3& corners : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Index a = place[corners[k]];
      const Index b = place[corners[(k + 1) % 3]];
      components.join(a, b);
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  }

  std::vector<Shape> shapes(place.size());
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
  for (std::size_t i = 0; i < edges.size();) {
    int sum = 0;
    const Edge first = edges[i];
    for (; i < edges.size() && edges[i].low == first.low && edges[i].high == first.high; ++i) {
      sum += edges[i].sense;
    }
    if (sum != 0) shapes[components.root(first.low)].closed = false;
  }
  for (const glm::uvec3& corners : mesh.triangles) {
    const Index component = components.root(place[corners[0]]);
    // Beside a vertex of the part, where the volume loses no digits.
    const glm::dvec3 origin(mesh.points[component]);
    std::array<glm::dvec3, 3> p;
    glm::dvec3 normals(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index corner = corners[static_cast<int>(k)];
      p[k] = glm::dvec3(mesh.points[corner]) - origin;
      normals += glm::dvec3(mesh.normals[corner]);
    }
    const double volume = glm::dot(p[0], glm::cross(p[1], p[2]));
    shapes[component].volume += volume;
    shapes[component].volumes += std::abs(volume);
    shapes[component].normals += glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), normals);
  }

  std::vector<Enclosed> result(place.size(), Enclosed::none);
  for (std::size_t i = 0; i < place.size(); ++i) {
    const Shape& shape = shapes[components.root(place[i])];
    // Two sheets in one place have none but roundings.
    if (!shape.closed || !(std::abs(shape.volume) > rounding * shape.volumes)) continue;
    const bool outward = (shape.volume > 0.0) == (shape.normals >= 0.0);
    result[i] = outward ? Enclosed::back : Enclosed::front;
  }
  return result;
}

}  // namespace brume
