#include "core/scene/lights/emitting_surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>

#include "brume/mesh_arrays.h"
#include "core/math/basis.h"
#include "core/math/max_component.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/materials/coverage.h"
#include "core/scene/placement.h"

namespace brume {
namespace {

// A rectangle in space: `up` is the unit direction of its height [u].
struct FilledRectangle {
  glm::dvec3 center{0.0};
  glm::dvec3 up{0.0};
  double width = 0.0;
  double height = 0.0;
};

// A rectangle around triangles, with a side along `right`.
struct Frame {
  glm::dvec3 right, up, normal;
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};

  Frame(std::span<const std::array<glm::dvec3, 3>> triangles, const glm::dvec3& side,
        const glm::dvec3& unit_normal)
      : right(side), up(glm::cross(side, unit_normal)), normal(unit_normal) {
    for (const auto& triangle : triangles) {
      for (const glm::dvec3& corner : triangle) {
        const glm::dvec2 place(glm::dot(corner, right), glm::dot(corner, up));
        low = glm::min(low, place);
        high = glm::max(high, place);
      }
    }
  }
  [[nodiscard]] double area() const { return (high.x - low.x) * (high.y - low.y); }
};

// So many triangles, spread over all of them, say along which sides a rectangle may lie.
constexpr std::size_t max_tried = 16;
constexpr double min_fill = 0.5;
constexpr double max_fill = 1.5;

// The rectangle, of this unit normal, that triangles fill which lie about in a plane of that normal
// and have this area in all: as large as they are, and as long as the smallest rectangle around
// them. nullopt where that is far from full, or they overlap in it: they then look like none.
std::optional<FilledRectangle> filled_rectangle(
    std::span<const std::array<glm::dvec3, 3>> triangles, double area, const glm::dvec3& normal) {
  if (triangles.empty()) return std::nullopt;
  Frame smallest(triangles, make_basis(normal).u, normal);
  const std::size_t step = (triangles.size() + max_tried - 1) / max_tried;
  for (std::size_t t = 0; t < triangles.size(); t += step) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 edge = triangles[t][(k + 1) % 3] - triangles[t][k];
      const glm::dvec3 side = edge - glm::dot(edge, normal) * normal;
      if (!(glm::length(side) > 0.0)) continue;
      const Frame frame(triangles, glm::normalize(side), normal);
      if (frame.area() < smallest.area()) smallest = frame;
    }
  }
  if (!(area > min_fill * smallest.area() && area < max_fill * smallest.area())) {
    return std::nullopt;
  }
  glm::dvec3 center(0.0);
  for (const auto& [a, b, c] : triangles) {
    const double share = 0.5 * glm::length(glm::cross(b - a, c - a)) / area;
    center += share / 3.0 * (a + b + c);
  }
  const double scale = std::sqrt(area / smallest.area());
  const glm::dvec2 size = scale * (smallest.high - smallest.low);
  return FilledRectangle{center, smallest.up, size.x, size.y};
}

// The radiance of a surface at a point of its mesh; nothing from its holes.
glm::dvec3 radiance_at(const Material& of_surface, const MeshValues& mesh) {
  const MetallicRoughness& material = of_surface.metallic_roughness;
  const Coverage coverage(of_surface);
  MeshValues middle = mesh;
  for (MeshValues::Texcoord& texcoord : middle.texcoords) texcoord.footprint = 0.0;
  if (coverage.is_hole(middle)) return glm::dvec3(0.0);
  return coverage.covered(mesh) * material.emissive *
         glm::dvec3(lookup(material.emissive_texture, mesh));
}

// A part of a triangle that emits.
struct Piece {
  std::array<glm::dvec3, 3> corners;
  std::array<MeshValues, 3> values;
  const Surface* surface;

  [[nodiscard]] glm::dvec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
  [[nodiscard]] double area() const { return glm::length(area_vector(corners)); }
  [[nodiscard]] glm::dvec3 radiance() const {
    MeshValues mean = interpolate(values, glm::dvec3(1.0 / 3.0));
    for (std::size_t set = 0; set < mean.texcoords.size(); ++set) {
      const glm::dvec2& first = values[0].texcoords[set].uv;
      const glm::dvec2 a = values[1].texcoords[set].uv - first;
      const glm::dvec2 b = values[2].texcoords[set].uv - first;
      mean.texcoords[set].footprint = std::sqrt(0.5 * std::abs(a.x * b.y - a.y * b.x));
    }
    return radiance_at(surface->material, mean);
  }
  // Its halves, cut through its longest edge.
  [[nodiscard]] std::array<Piece, 2> halves() const {
    std::size_t longest = 0;
    double length = -1.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double edge = glm::distance(corners[k], corners[(k + 1) % 3]);
      if (edge > length) {
        length = edge;
        longest = k;
      }
    }
    const std::size_t next = (longest + 1) % 3;
    Piece first = *this;
    Piece second = *this;
    first.corners[next] = second.corners[longest] = 0.5 * (corners[longest] + corners[next]);
    glm::dvec3 halves(0.0);
    halves[static_cast<int>(longest)] = halves[static_cast<int>(next)] = 0.5;
    first.values[next] = second.values[longest] = interpolate(values, halves);
    return {first, second};
  }
};

// Whether a mesh has an outside that its triangles face: it has no edge, vertices at one place
// taken as one.
bool has_outside(const MeshArrays& mesh) {
  std::vector<std::size_t> order(mesh.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&mesh](std::size_t vertex) {
    const glm::vec3& p = mesh.points[vertex];
    return std::tuple(p.x, p.y, p.z);
  };
  std::ranges::sort(order, {}, key);
  std::vector<unsigned> place(order.size());
  for (std::size_t k = 1; k < order.size(); ++k) {
    place[order[k]] = place[order[k - 1]] + (key(order[k]) == key(order[k - 1]) ? 0 : 1);
  }
  std::vector<std::pair<unsigned, unsigned>> edges, reversed;
  double volume = 0.0;
  for (const glm::uvec3& corners : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const unsigned from = place[corners[k]];
      const unsigned to = place[corners[(k + 1) % 3]];
      edges.emplace_back(from, to);
      reversed.emplace_back(to, from);
    }
    const glm::dvec3 a(mesh.points[corners.x]);
    volume += glm::dot(
        a, glm::cross(glm::dvec3(mesh.points[corners.y]), glm::dvec3(mesh.points[corners.z])));
  }
  std::ranges::sort(edges);
  std::ranges::sort(reversed);
  return volume > 0.0 && edges == reversed;
}

// Calls visit(piece, surface, copy, triangle) for all triangles of surfaces that emit.
template <class Visit>
void for_each_emitting(std::span<const Surface> surfaces, Visit visit) {
  const auto visit_placement = [&visit](const Surface& surface, std::size_t s, std::size_t copy) {
    const MeshArrays& mesh = to_arrays(*surface.mesh);
    const Placement placement = placement_of(surface, copy);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Piece piece{.corners = {}, .values = corner_values(mesh, t), .surface = &surface};
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 corner(mesh.points[mesh.triangles[t][k]]);
        piece.corners[static_cast<std::size_t>(k)] = placement.point_to_world(corner);
      }
      visit(piece, s, copy, t);
    }
  };
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (!is_emissive(surfaces[s])) continue;
    for (std::size_t copy = 0; copy < placement_count(surfaces[s]); ++copy) {
      visit_placement(surfaces[s], s, copy);
    }
  }
}

// A piece as a light, whose intensity falls off by the cosine from its normal.
struct Source {
  glm::dvec3 position;
  glm::dvec3 normal;     // unit
  glm::dvec3 intensity;  // area times radiance [W/sr]
  double area;
  bool is_two_sided;
  std::array<glm::dvec3, 3> corners;

  [[nodiscard]] double power() const { return max_component(intensity); }
  // The side of a cube that its normal points to; one of two opposite ones if it shines to both.
  [[nodiscard]] int facing() const {
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (!is_two_sided && normal[axis] < 0.0 ? 1 : 0);
  }
};

// Triangles are cut until the pieces are so many for each point that stands for them.
constexpr int pieces_per_point = 16;

// The pieces that matter, cut where they send most.
std::vector<Source> sources_of(std::span<const Surface> surfaces, int max_count) {
  const auto size = static_cast<std::size_t>(pieces_per_point * max_count);
  struct Weighted {
    Piece piece;
    double power;
    bool operator<(const Weighted& other) const { return power < other.power; }
  };
  const auto weighted = [](const Piece& piece) {
    return Weighted{
        piece, piece.area() * max_component(piece.surface->material.metallic_roughness.emissive)};
  };
  std::priority_queue<Weighted> pieces;
  for_each_emitting(surfaces, [&](const Piece& piece, std::size_t, std::size_t, std::size_t) {
    if (piece.area() > 0.0) pieces.push(weighted(piece));
  });
  while (!pieces.empty() && pieces.size() < size) {
    const Piece largest = pieces.top().piece;
    pieces.pop();
    for (const Piece& half : largest.halves()) pieces.push(weighted(half));
  }
  std::map<const Surface*, bool> closed;
  for (const Surface& surface : surfaces) {
    if (is_emissive(surface)) closed[&surface] = has_outside(to_arrays(*surface.mesh));
  }
  std::vector<Source> sources;
  for (; !pieces.empty(); pieces.pop()) {
    const Piece& piece = pieces.top().piece;
    const double area = piece.area();
    const glm::dvec3 intensity = area * piece.radiance();
    if (!(max_component(intensity) > 0.0)) continue;
    sources.push_back({piece.middle(), area_vector(piece.corners) / area, intensity, area,
                       !closed[piece.surface], piece.corners});
  }
  return sources;
}

// Pieces that one point may stand for.
struct Cluster {
  std::vector<Source> sources;
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};
  double power = 0.0;

  void add(const Source& source) {
    sources.push_back(source);
    low = glm::min(low, source.position);
    high = glm::max(high, source.position);
    power += source.power();
  }
  [[nodiscard]] bool can_be_split() const { return sources.size() > 1 && low != high; }
  // How much is gained by splitting it.
  [[nodiscard]] double spread() const {
    return can_be_split() ? power * glm::distance(low, high) : 0.0;
  }
  bool operator<(const Cluster& other) const { return spread() < other.spread(); }

  // Two that send about as much, cut across the longest side.
  [[nodiscard]] std::array<Cluster, 2> halves() const {
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<Source> sorted = sources;
    std::ranges::sort(sorted, {}, [axis](const Source& source) { return source.position[axis]; });
    std::array<Cluster, 2> halves;
    for (const Source& source : sorted) {
      const bool is_first =
          halves[0].sources.empty() ||
          (halves[0].power + 0.5 * source.power() < 0.5 * power && &source != &sorted.back());
      halves[is_first ? 0 : 1].add(source);
    }
    return halves;
  }

  // It sends all of their light from the piece next to their middle, as that faces.
  [[nodiscard]] PointLight point() const {
    glm::dvec3 middle(0.0), intensity(0.0), normal(0.0);
    double area = 0.0;
    for (const Source& source : sources) {
      middle += source.power() / power * source.position;
      intensity += source.intensity;
      const double side = glm::dot(source.normal, sources.front().normal) < 0.0 ? -1.0 : 1.0;
      normal += side * source.power() * source.normal;
      area += source.area;
    }
    const Source& nearest = *std::ranges::min_element(
        sources, {}, [&](const Source& source) { return glm::distance(source.position, middle); });
    if (!(glm::length(normal) > 0.0)) normal = nearest.normal;
    normal = glm::normalize(normal);
    PointLight light{.position = nearest.position,
                     .intensity = intensity,
                     .falloff = LightFalloff::of_surface(normal, nearest.is_two_sided),
                     .radius = std::sqrt(area * std::numbers::inv_pi),
                     .is_seen = true};
    if (const auto outline = filled_rectangle(triangles(), area, normal)) {
      light.area = light::Rectangle{.direction = normal,
                                    .up = outline->up,
                                    .width = outline->width,
                                    .height = outline->height,
                                    .two_sided = nearest.is_two_sided};
      light.area_center = outline->center;
      light.area_points = 1;
    }
    return light;
  }

 private:
  [[nodiscard]] std::vector<std::array<glm::dvec3, 3>> triangles() const {
    std::vector<std::array<glm::dvec3, 3>> triangles;
    for (const Source& source : sources) triangles.push_back(source.corners);
    return triangles;
  }
};

}  // namespace

bool emits(const Material& material) {
  return material.type == Material::Type::metallic_roughness &&
         material.metallic_roughness.emissive != glm::dvec3(0.0);
}

bool is_emissive(const Surface& surface) {
  return emits(surface.material);
}

glm::dvec3 area_vector(const std::array<glm::dvec3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return 0.5 * glm::cross(b - a, c - a);
}

std::size_t emitter_count(std::span<const Surface> surfaces) {
  std::size_t count = 0;
  for (const Surface& surface : surfaces) {
    if (is_emissive(surface)) count += placement_count(surface);
  }
  return count;
}

std::vector<EmittingTriangle> emitting_triangles(std::span<const Surface> surfaces) {
  std::vector<EmittingTriangle> triangles;
  for_each_emitting(
      surfaces, [&](const Piece& piece, std::size_t surface, std::size_t copy, std::size_t index) {
        triangles.push_back({piece.corners, piece.radiance(), static_cast<std::uint32_t>(surface),
                             static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(copy)});
      });
  return triangles;
}

std::vector<PointLight> emitting_points(std::span<const Surface> surfaces, int max_count) {
  constexpr int side_count = 6;
  std::array<Cluster, side_count> sides;
  for (const Source& source : sources_of(surfaces, max_count)) {
    sides[max_count < side_count ? 0 : static_cast<std::size_t>(source.facing())].add(source);
  }
  std::priority_queue<Cluster> clusters;
  for (const Cluster& side : sides) {
    if (!side.sources.empty()) clusters.push(side);
  }
  while (!clusters.empty() && static_cast<int>(clusters.size()) < max_count &&
         clusters.top().can_be_split()) {
    const Cluster largest = clusters.top();
    clusters.pop();
    for (const Cluster& half : largest.halves()) clusters.push(half);
  }
  std::vector<PointLight> lights;
  for (; !clusters.empty(); clusters.pop()) {
    lights.push_back(clusters.top().point());
    lights.back().index = static_cast<int>(lights.size()) - 1;
  }
  return lights;
}

}  // namespace brume
