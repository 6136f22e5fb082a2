#include "render/cpu/triangle_beams.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace brume {
namespace {

constexpr std::uint32_t no_triangle = ~0u;

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const PlacedTriangle& triangle) {
  const auto& [a, b, c] = triangle.positions;
  return {a, b, c};
}

// Numbers where corners are: the same for corners at the same place, whichever vertices they are,
// so that seams of a mesh are none.
std::vector<glm::uvec3> places_of(std::span<const PlacedTriangle> triangles) {
  std::vector<glm::uvec3> places(triangles.size());  // first of all, vertices of all surfaces
  std::vector<glm::vec3> positions;
  std::size_t first = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const PlacedTriangle& triangle = triangles[t];
    if (t > 0 && triangle.surface != triangles[t - 1].surface) first = positions.size();
    for (int k = 0; k < 3; ++k) {
      const std::size_t vertex = first + triangle.vertices[k];
      positions.resize(std::max(positions.size(), vertex + 1));
      positions[vertex] = triangle.positions[static_cast<std::size_t>(k)];
      places[t][k] = static_cast<std::uint32_t>(vertex);
    }
  }
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) {
    return std::tie(positions[i].x, positions[i].y, positions[i].z);
  });
  std::vector<std::uint32_t> place_of(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_there_already = i > 0 && positions[order[i]] == positions[order[i - 1]];
    place_of[order[i]] = is_there_already ? place_of[order[i - 1]] : static_cast<std::uint32_t>(i);
  }
  for (glm::uvec3& of : places) of = {place_of[of.x], place_of[of.y], place_of[of.z]};
  return places;
}

// Across the edges from each corner to the next; no_triangle where there is none or more than one.
std::vector<std::array<std::uint32_t, 3>> neighbours_of(std::span<const PlacedTriangle> triangles) {
  struct Side {
    std::uint32_t low, high;  // places
    std::uint32_t triangle, edge;
  };
  const std::vector<glm::uvec3> places = places_of(triangles);
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax({places[t][static_cast<int>(k)], places[t][static_cast<int>((k + 1) % 3)]});
      sides.push_back({low, high, t, k});
    }
  }
  const auto edge = [](const Side& s) { return std::tie(s.low, s.high); };
  std::ranges::sort(sides, {}, edge);
  std::vector<std::array<std::uint32_t, 3>> result(triangles.size());
  for (std::array<std::uint32_t, 3>& none : result) none.fill(no_triangle);
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && edge(sides[last]) == edge(sides[first])) ++last;
    if (last - first != 2) continue;
    const Side& a = sides[first];
    const Side& b = sides[first + 1];
    result[a.triangle][a.edge] = b.triangle;
    result[b.triangle][b.edge] = a.triangle;
  }
  return result;
}

// Where points x with dot(normal, x) <= most are.
struct HalfSpace {
  glm::dvec3 normal{0.0};  // unit, or 0: all of space
  double most = 0.0;

  [[nodiscard]] double beyond(const glm::dvec3& p) const { return glm::dot(normal, p) - most; }
  [[nodiscard]] bool holds_none_of(const TriangleHierarchy::Child& box) const {
    const glm::dvec3 nearest = glm::mix(glm::dvec3(box.high), glm::dvec3(box.low),
                                        glm::greaterThan(normal, glm::dvec3(0.0)));
    return beyond(nearest) > 0.0;
  }
};

// A part of a triangle: the weights of the triangle's corners at the part's.
using PartCorners = std::array<glm::dvec3, 3>;

PartCorners part_corners(std::uint32_t part) {
  constexpr double step = 1.0 / TrianglePart::along;
  const double u = step * static_cast<double>(part / 2 / TrianglePart::along);
  const double v = step * static_cast<double>(part / 2 % TrianglePart::along);
  const auto at = [](double x, double y) { return glm::dvec3(1.0 - x - y, x, y); };
  if (part % 2 == 0) return {at(u, v), at(u + step, v), at(u, v + step)};
  return {at(u + step, v + step), at(u, v + step), at(u + step, v)};
}

constexpr PartCorners all_of_it{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

// A triangle of which half-spaces have cut off what they do not hold.
class Clipped {
 public:
  explicit Clipped(const Corners& corners) : count_(corners.size()) {
    std::ranges::copy(corners, points_.begin());
  }

  [[nodiscard]] std::span<const glm::dvec3> points() const {
    return std::span(points_).first(count_);
  }

  void clip(const HalfSpace& by) {
    const Points from = points_;
    const std::size_t count = std::exchange(count_, 0);
    for (std::size_t k = 0; k < count; ++k) {
      const glm::dvec3& a = from[k];
      const glm::dvec3& b = from[(k + 1) % count];
      const double beyond_a = by.beyond(a);
      const double beyond_b = by.beyond(b);
      if (beyond_a <= 0.0) points_[count_++] = a;
      if (beyond_a * beyond_b < 0.0) {
        points_[count_++] = a + beyond_a / (beyond_a - beyond_b) * (b - a);
      }
    }
  }

 private:
  // Each of four half-spaces adds one, or two by roundings.
  using Points = std::array<glm::dvec3, 3 + 2 * 4>;
  Points points_;
  std::size_t count_;
};

}  // namespace

class TriangleBeams::Beam {
 public:
  // None where normals do not tell the triangle's sides apart.
  static std::optional<Beam> of(const PlacedTriangle& triangle, const PartCorners& part,
                                const glm::dvec3& light, const Margins& margins) {
    const Corners corners = corners_of(triangle);
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(across);
    if (!(length > 0.0)) return std::nullopt;
    const double towards_light = glm::dot(across, light - corners[0]) < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 geometric = towards_light / length * across;
    const std::int8_t side = glm::dot(glm::dvec3(triangle.normals[0]), geometric) < 0.0 ? -1 : 1;
    Corners normals;
    for (std::size_t k = 0; k < 3; ++k) {
      normals[k] = static_cast<double>(side) * glm::dvec3(triangle.normals[k]);
      if (!(glm::dot(normals[k], geometric) > 0.0)) return std::nullopt;
    }
    Beam beam(light, margins);
    beam.side_ = side;
    for (std::size_t i = 0; i < 3; ++i) {
      beam.target_[i] = mix(part[i], corners);
    }
    beam.add_origins(part, corners, normals, margins.offset * geometric);
    beam.enclose(geometric);
    return beam;
  }

  [[nodiscard]] const glm::dvec3& light() const { return points_[0]; }
  [[nodiscard]] std::int8_t side() const { return side_; }
  // The corners of what it goes to.
  [[nodiscard]] const Corners& target() const { return target_; }

  // Whether no ray meets this.
  [[nodiscard]] bool misses(const PlacedTriangle& triangle) const {
    const Corners corners = corners_of(triangle);
    Clipped inside = between_sides(corners);
    inside.clip(floor_);
    return inside.points().empty() || lies_beside(corners);
  }
  [[nodiscard]] bool misses(const TriangleHierarchy::Child& box) const {
    for (int k = 0; k < 3; ++k) {
      if (static_cast<double>(box.low[k]) > high_[k] || static_cast<double>(box.high[k]) < low_[k])
        return true;
    }
    return floor_.holds_none_of(box) ||
           std::ranges::any_of(sides_, [&](const HalfSpace& s) { return s.holds_none_of(box); });
  }

  // Whether what the sides enclose of a triangle is between the light and where rays start, away
  // from both.
  [[nodiscard]] bool has_between_ends(const Corners& corners) const {
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    // Sides bulge, so that a triangle on which the light is may reach around it.
    const double height = std::abs(glm::dot(across, light() - corners[0]));
    if (!(height > margins_.ends * glm::length(across))) return false;
    const Clipped part = between_sides(corners);
    return std::ranges::all_of(part.points(),
                               [&](const glm::dvec3& p) { return ceiling_.beyond(p) > 0.0; });
  }

  // Whether the beam, made endless, holds any of the edge between two points.
  [[nodiscard]] bool holds_any_of(const glm::dvec3& a, const glm::dvec3& b) const {
    double first = 0.0;
    double last = 1.0;
    for (const HalfSpace& side : sides_) {
      const double beyond_a = side.beyond(a);
      const double beyond_b = side.beyond(b);
      if (beyond_a > 0.0 && beyond_b > 0.0) return false;
      const double crossing = beyond_a / (beyond_a - beyond_b);
      if (beyond_a > 0.0) first = std::max(first, crossing);
      if (beyond_b > 0.0) last = std::min(last, crossing);
    }
    return first <= last;
  }

 private:
  Beam(const glm::dvec3& light, const Margins& margins) : margins_(margins) { add(light); }

  void add(const glm::dvec3& point) {
    points_[count_++] = point;
    low_ = glm::min(low_, point - margins_.tolerance);
    high_ = glm::max(high_, point + margins_.tolerance);
  }

  // Origins leave the triangle by
  //   lift + sum_k w_k max(0, sum_j w_j rise_kj) n_k,  rise_kj = dot(p_k - p_j, n_k),
  // w the barycentric coordinates. The maximum is between 0 and sum_j w_j max(0, rise_kj), so that
  // they are in the hull of the control points of quadratic Bezier triangles: each with any of the
  // three normals left out.
  void add_origins(const PartCorners& part, const Corners& corners, const Corners& normals,
                   const glm::dvec3& lift) {
    std::array<glm::dvec3, 3> rise;  // of n_k, by the weights of the corners
    for (int k = 0; k < 3; ++k) {
      const auto c = static_cast<std::size_t>(k);
      for (int j = 0; j < 3; ++j) {
        const auto from = static_cast<std::size_t>(j);
        rise[c][j] = std::max(glm::dot(corners[c] - corners[from], normals[c]), 0.0);
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t l = i; l < 3; ++l) {
        const glm::dvec3& a = part[i];
        const glm::dvec3& b = part[l];
        const glm::dvec3 middle = 0.5 * (mix(a, corners) + mix(b, corners)) + lift;
        std::array<glm::dvec3, 3> steps;
        std::size_t count = 0;
        for (int k = 0; k < 3; ++k) {
          const auto c = static_cast<std::size_t>(k);
          const double height = 0.5 * (a[k] * glm::dot(rise[c], b) + b[k] * glm::dot(rise[c], a));
          if (height > 0.0) steps[count++] = height * normals[c];
        }
        for (std::size_t some = 0; some < std::size_t{1} << count; ++some) {
          glm::dvec3 point = middle;
          for (std::size_t k = 0; k < count; ++k) {
            if ((some >> k & 1) != 0) point += steps[k];
          }
          add(point);
        }
      }
    }
  }

  static glm::dvec3 mix(const glm::dvec3& weights, const Corners& of) {
    return weights.x * of[0] + weights.y * of[1] + weights.z * of[2];
  }

  void enclose(const glm::dvec3& geometric) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3& a = target_[k];
      glm::dvec3 out = glm::cross(a - light(), target_[(k + 1) % 3] - light());
      if (glm::dot(out, target_[(k + 2) % 3] - a) > 0.0) out *= -1.0;
      sides_[k] = around(out, points());
    }
    floor_ = around(-geometric, points());
    ceiling_ = around(geometric, points().subspan(1));
    ceiling_.most += margins_.ends;
  }

  [[nodiscard]] HalfSpace around(const glm::dvec3& out, std::span<const glm::dvec3> points) const {
    const double length = glm::length(out);
    if (!(length > 0.0)) return {};
    HalfSpace result{out / length, -std::numeric_limits<double>::infinity()};
    for (const glm::dvec3& p : points) {
      result.most = std::max(result.most, glm::dot(result.normal, p));
    }
    result.most += margins_.tolerance;
    return result;
  }

  [[nodiscard]] Clipped between_sides(const Corners& corners) const {
    Clipped part(corners);
    for (const HalfSpace& side : sides_) part.clip(side);
    return part;
  }

  // Whether all of the beam is on one side of a triangle's plane.
  [[nodiscard]] bool lies_beside(const Corners& corners) const {
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double least = margins_.tolerance * glm::length(across);
    if (!(least > 0.0)) return false;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const glm::dvec3& p : points()) {
      const double above = glm::dot(across, p - corners[0]);
      low = std::min(low, above);
      high = std::max(high, above);
    }
    return low > least || high < -least;
  }

  [[nodiscard]] std::span<const glm::dvec3> points() const {
    return std::span(points_).first(count_);
  }

  Margins margins_;
  std::int8_t side_ = 1;
  Corners target_;
  // Whose hull the beam is: the light, then up to eight for each control point.
  std::array<glm::dvec3, 1 + 6 * 8> points_;
  std::size_t count_ = 0;
  glm::dvec3 low_{std::numeric_limits<double>::infinity()};
  glm::dvec3 high_{-std::numeric_limits<double>::infinity()};
  std::array<HalfSpace, 3> sides_;
  HalfSpace floor_;    // along the triangle: holds the beam
  HalfSpace ceiling_;  // holds where its rays start
};

TriangleBeams::TriangleBeams(const Visibility& visibility)
    : visibility_(visibility),
      triangles_(visibility.triangles()),
      hierarchy_(triangles_),
      neighbours_(neighbours_of(triangles_)) {
  // Hits as near as two margins to the ends of a ray do not count.
  margins_.offset = Visibility::self_hit_margin * visibility.radius();
  margins_.tolerance = 0.2 * margins_.offset;
  margins_.ends = 3.0 * margins_.offset;
}

SideSight TriangleBeams::sight(const glm::dvec3& light, std::uint32_t triangle) const {
  const std::optional<Beam> beam = Beam::of(triangles_[triangle], all_of_it, light, margins_);
  if (!beam) return {TriangleSight::in_part};
  const TriangleSight whole = sight(*beam);
  return {whole == TriangleSight::in_part ? sight_of_parts(light, triangle) : whole, beam->side()};
}

// What parts agree on: their beams are thinner.
TriangleSight TriangleBeams::sight_of_parts(const glm::dvec3& light, std::uint32_t triangle) const {
  TriangleSight all = TriangleSight::unknown;
  for (std::uint32_t part = 0; part < TrianglePart::count; ++part) {
    if (!TrianglePart::exists(part)) continue;
    const TriangleSight sight = sight_of_part(light, triangle, part);
    if (sight == TriangleSight::in_part) return sight;
    if (all != TriangleSight::unknown && sight != all) return TriangleSight::in_part;
    all = sight;
  }
  return all;
}

TriangleSight TriangleBeams::sight_of_part(const glm::dvec3& light, std::uint32_t triangle,
                                           std::uint32_t part) const {
  const std::optional<Beam> beam =
      Beam::of(triangles_[triangle], part_corners(part), light, margins_);
  return beam ? sight(*beam) : TriangleSight::in_part;
}

TriangleSight TriangleBeams::sight(const Beam& beam) const {
  if (hierarchy_.nodes.empty()) return TriangleSight::in_part;
  if (is_clear(beam)) return TriangleSight::whole;
  return is_covered(beam) ? TriangleSight::none : TriangleSight::in_part;
}

bool TriangleBeams::is_clear(const Beam& beam) const {
  std::array<std::int32_t, TriangleHierarchy::most_levels + 1> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    for (const TriangleHierarchy::Child& child :
         hierarchy_.nodes[static_cast<std::size_t>(stack[--waiting])].children) {
      if (child.first < 0 || beam.misses(child)) continue;
      if (child.count == 0) {
        stack[waiting++] = child.first;
        continue;
      }
      for (std::int32_t k = 0; k < child.count; ++k) {
        const std::uint32_t other = hierarchy_.order[static_cast<std::size_t>(child.first + k)];
        if (!beam.misses(triangles_[other])) return false;
      }
    }
  }
  return true;
}

// By any of the first surfaces that a ray down its middle meets.
bool TriangleBeams::is_covered(const Beam& beam) const {
  const Corners& target = beam.target();
  const glm::dvec3 way = (target[0] + target[1] + target[2]) / 3.0 - beam.light();
  const double length = glm::length(way);
  const glm::dvec3 direction = way / length;
  double from = 0.0;
  for (int layer = 0; layer < 4; ++layer) {
    const SurfaceHit hit =
        visibility_.first_hit(visibility_.middle() + beam.light() + from * direction, direction);
    if (!hit || from + hit.distance > length - margins_.ends) return false;
    if (is_covered(beam, visibility_.index_of(hit))) return true;
    from += hit.distance + margins_.offset;
  }
  return false;
}

// By a patch of triangles across it, neighbour by neighbour from this one, which it meets. If the
// patch has, seen from the light, no fold and no end within the beam, it covers all of it.
bool TriangleBeams::is_covered(const Beam& beam, std::uint32_t triangle) const {
  const glm::dvec3& light = beam.light();
  std::array<std::uint32_t, 256> patch;
  std::size_t count = 0;
  patch[count++] = triangle;
  for (std::size_t at = 0; at < count; ++at) {
    const Corners corners = corners_of(triangles_[patch[at]]);
    if (!beam.has_between_ends(corners)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3& a = corners[k];
      const glm::dvec3& b = corners[(k + 1) % 3];
      if (!beam.holds_any_of(a, b)) continue;
      const std::uint32_t next = neighbours_[patch[at]][k];
      if (next == no_triangle) return false;
      const Corners beyond = corners_of(triangles_[next]);
      const glm::dvec3 apex = beyond[0] + beyond[1] + beyond[2] - a - b;
      const glm::dvec3 out = glm::cross(a - light, b - light);
      const bool folds = !(glm::dot(out, corners[(k + 2) % 3] - a) * glm::dot(out, apex - a) < 0.0);
      if (folds) return false;
      const auto last = patch.begin() + static_cast<std::ptrdiff_t>(count);
      if (std::find(patch.begin(), last, next) != last) continue;
      if (last == patch.end()) return false;
      patch[count++] = next;
    }
  }
  return true;
}

}  // namespace brume
