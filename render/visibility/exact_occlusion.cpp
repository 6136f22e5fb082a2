#include "render/visibility/exact_occlusion.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

namespace brume {
namespace {

// The surface at the end of the view ray touches it and must not occlude it: occluders closer to
// the ray than this fraction of the light's distance are ignored.
constexpr double touching = 1e-9;

// Holes of textures are found by so many steps along a triangle, and their edges by bisection.
constexpr int hole_steps = 512;
constexpr int edge_steps = 30;

using Segment = std::array<glm::dvec2, 2>;

// The ends of a segment as weights of a triangle's corners.
using Ends = std::array<glm::dvec3, 2>;

// Calls visit(a, b) for the parts of a segment, from 0 to 1, that are no holes.
void each_solid_part(auto&& is_hole, auto&& visit) {
  const auto edge = [&](double solid, double hole) {
    for (int k = 0; k < edge_steps; ++k) {
      const double middle = 0.5 * (solid + hole);
      (is_hole(middle) ? hole : solid) = middle;
    }
    return solid;
  };
  double begin = is_hole(0.0) ? -1.0 : 0.0;  // of the part; < 0: in a hole
  for (int k = 1; k <= hole_steps; ++k) {
    const double at = static_cast<double>(k) / hole_steps;
    const double before = static_cast<double>(k - 1) / hole_steps;
    const bool is_in_hole = is_hole(at);
    if (is_in_hole && begin >= 0.0) {
      visit(begin, edge(before, at));
      begin = -1.0;
    } else if (!is_in_hole && begin < 0.0) {
      begin = edge(at, before);
    }
  }
  if (begin >= 0.0) visit(begin, 1.0);
}

// Where a triangle meets the plane through `origin` spanned by x and y, in those coordinates.
std::optional<Segment> cross_section(const std::array<glm::dvec3, 3>& triangle,
                                     const glm::dvec3& origin, const glm::dvec3& x,
                                     const glm::dvec3& y, const glm::dvec3& normal, Ends& ends) {
  std::array<double, 3> height;
  for (std::size_t k = 0; k < 3; ++k) height[k] = glm::dot(triangle[k] - origin, normal);
  Segment segment;
  std::size_t found = 0;
  for (std::size_t k = 0; k < 3 && found < 2; ++k) {
    const std::size_t next = (k + 1) % 3;
    // A corner in the plane counts as above it, so that a crossing is found once.
    if ((height[k] < 0.0) == (height[next] < 0.0)) continue;
    const double s = height[k] / (height[k] - height[next]);
    const glm::dvec3 q = triangle[k] + s * (triangle[next] - triangle[k]) - origin;
    ends[found] = glm::dvec3(0.0);
    ends[found][static_cast<int>(k)] = 1.0 - s;
    ends[found][static_cast<int>(next)] = s;
    segment[found++] = {glm::dot(q, x), glm::dot(q, y)};
  }
  return found == 2 ? std::optional(segment) : std::nullopt;
}

// The part of a segment with y in [low, high].
bool clip(Segment& s, double low, double high) {
  if (s[0].y > s[1].y) std::swap(s[0], s[1]);
  if (!(s[0].y < high && s[1].y > low)) return false;
  const glm::dvec2 step = s[1] - s[0];
  const Segment original = s;
  if (original[0].y < low) s[0] = original[0] + (low - original[0].y) / step.y * step;
  if (original[1].y > high) s[1] = original[0] + (high - original[0].y) / step.y * step;
  return true;
}

constexpr double infinite = std::numeric_limits<double>::infinity();

// Beyond so many triangles, so many neighbours have one sphere: that takes less memory.
constexpr std::size_t max_alone = 1'000'000;
constexpr std::size_t neighbours = 8;

std::size_t group_size(std::size_t triangles) {
  return triangles > max_alone ? neighbours : 1;
}

// The triangles along a space-filling curve, Morton's.
std::vector<std::uint32_t> order_along_curve(const TriangleMesh& mesh) {
  const MeshBox box = box_of(mesh);
  const glm::dvec3 scale = 1023.0 / glm::max(box.high - box.low, glm::dvec3(1e-300));
  const auto spread = [](std::uint32_t bits) {  // to every third
    bits = (bits | bits << 16) & 0x030000ffU;
    bits = (bits | bits << 8) & 0x0300f00fU;
    bits = (bits | bits << 4) & 0x030c30c3U;
    return (bits | bits << 2) & 0x09249249U;
  };
  std::vector<std::uint64_t> keys(mesh.n_faces());  // the place on the curve, and the triangle
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t triangle) {
    const glm::dvec3 cell = (glm::dvec3(mesh.points[mesh.triangles[triangle].x]) - box.low) * scale;
    const std::uint32_t code = spread(static_cast<std::uint32_t>(cell.x)) |
                               spread(static_cast<std::uint32_t>(cell.y)) << 1 |
                               spread(static_cast<std::uint32_t>(cell.z)) << 2;
    keys[triangle] = std::uint64_t{code} << 32 | triangle;
  });
  tbb::parallel_sort(keys);
  std::vector<std::uint32_t> order(keys.size());
  std::ranges::transform(keys, order.begin(),
                         [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

}  // namespace

ExactOcclusion::Part::Part(const Surface& surface, const Placement& own_placement)
    : mesh(surface.mesh), placement(own_placement), coverage(surface.material) {
  if (mesh->n_faces() > max_alone) {
    order = order_along_curve(*mesh);
  } else {
    order.resize(mesh->n_faces());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::transform(mesh->points, std::back_inserter(points), [this](const glm::vec3& p) {
      return placement.point_to_world(glm::dvec3(p));
    });
  }
  const std::size_t size = group_size(order.size());
  const std::size_t group_count = (order.size() + size - 1) / size;
  std::vector<glm::dvec3> centers(group_count);
  std::vector<double> radii(group_count);
  tbb::parallel_for(std::size_t{0}, group_count, [&](std::size_t group) {
    glm::dvec3 low(infinite), high(-infinite);
    for (std::size_t i = group * size; i < std::min((group + 1) * size, order.size()); ++i) {
      for (const glm::dvec3& p : triangle(order[i])) {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    centers[group] = 0.5 * (low + high);
    radii[group] = 0.5 * glm::length(high - low);
  });
  bvh = SphereBvh(centers, radii);
}

ExactOcclusion::Triangle ExactOcclusion::Part::triangle(std::uint32_t index) const {
  const glm::uvec3& corners = mesh->triangles[index];
  return {point(corners.x), point(corners.y), point(corners.z)};
}

void ExactOcclusion::Part::query(const auto& shape, auto visit) const {
  const std::size_t size = group_size(order.size());
  bvh.query(shape, [&](std::uint32_t group) {
    const std::size_t first = group * size;
    for (std::size_t i = first; i < std::min(first + size, order.size()); ++i) visit(order[i]);
  });
}

ExactOcclusion::ExactOcclusion(std::span<const Surface> surfaces) {
  const Placement none{CopyPlacement()};
  std::vector<glm::dvec3> centers;
  std::vector<double> radii;
  for (const Surface& surface : surfaces) {
    const bool has_copies = surface.placed_copies != nullptr;
    const auto part = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back(std::make_unique<const Part>(surface, has_copies ? none : Placement(surface)));
    glm::dvec3 low(infinite), high(-infinite);
    for (std::uint32_t v = 0; v < surface.mesh->n_vertices(); ++v) {
      const glm::dvec3 p = parts_.back()->point(v);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    for (std::size_t copy = 0; copy < placement_count(surface); ++copy) {
      const Placement placement = has_copies ? placement_of(surface, copy) : none;
      instances_.push_back({part, placement});
      centers.push_back(placement.point_to_world(0.5 * (low + high)));
      radii.push_back(placement.scale * 0.5 * glm::length(high - low));
    }
  }
  bvh_ = SphereBvh(centers, radii);
}

bool ExactOcclusion::Part::is_hole(std::uint32_t index, const glm::dvec3& weights) const {
  return coverage.has_holes() && coverage.is_hole(values_in(*mesh, index, weights));
}

void ExactOcclusion::Part::shorten(const glm::dvec3& origin, const glm::dvec3& direction,
                                   double& end) const {
  query(RaySegment{origin, direction, end}, [&](std::uint32_t i) {
    // Moeller and Trumbore 1997.
    const Triangle corners = triangle(i);
    const glm::dvec3 e1 = corners[1] - corners[0];
    const glm::dvec3 e2 = corners[2] - corners[0];
    const glm::dvec3 p = glm::cross(direction, e2);
    const double det = glm::dot(e1, p);
    if (det == 0.0) return;
    const glm::dvec3 q = origin - corners[0];
    const double u = glm::dot(q, p) / det;
    const double v = glm::dot(direction, glm::cross(q, e1)) / det;
    const double t = glm::dot(e2, glm::cross(q, e1)) / det;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0)) return;
    if (!is_hole(i, {1.0 - u - v, u, v})) end = std::min(end, t);
  });
}

double ExactOcclusion::first_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                                 double end) const {
  double nearest = end;
  bvh_.query(RaySegment{origin, direction, end}, [&](std::uint32_t i) {
    const auto& [part, placement] = instances_[i];
    double own_end = nearest / placement.scale;
    parts_[part]->shorten(placement.point_to_mesh(origin), placement.normal_to_mesh(direction),
                          own_end);
    nearest = std::min(nearest, own_end * placement.scale);
  });
  return nearest;
}

std::vector<std::pair<double, double>> ExactOcclusion::lit(const glm::dvec3& light,
                                                           const glm::dvec3& eye,
                                                           const glm::dvec3& w, double end) const {
  const glm::dvec3 q = light - eye;
  const double ts = glm::dot(q, w);
  const glm::dvec3 to_ray = ts * w - q;  // from the light to the nearest point of the ray
  const double h = glm::length(to_ray);
  if (h <= 1e-9 * glm::length(q)) {
    // The light is on the ray, and shines along it both ways until something stops it.
    const double backward_hit = first_hit(light, -w, std::abs(ts) + end);
    const double forward_hit = first_hit(light, w, std::abs(ts) + end);
    const double begin = std::clamp(ts - backward_hit, 0.0, end);
    const double last = std::clamp(ts + forward_hit, 0.0, end);
    if (begin < last) return {{begin, last}};
    return {};
  }

  const glm::dvec3 y = to_ray / h;
  const glm::dvec3 normal = glm::cross(w, y);
  // Angles at the light, 0 at the foot of the ray.
  const double first = std::atan2(-ts, h);
  const double last = std::atan2(end - ts, h);
  std::vector<std::pair<double, double>> hidden;
  // Angles are the same in a part's own coordinates.
  const auto hide_part = [&](const Part& part, const Placement& placement) {
    const glm::dvec3 own_light = placement.point_to_mesh(light);
    const glm::dvec3 own_eye = placement.point_to_mesh(eye);
    const glm::dvec3 own_w = placement.normal_to_mesh(w);
    const glm::dvec3 own_y = placement.normal_to_mesh(y);
    const glm::dvec3 own_normal = placement.normal_to_mesh(normal);
    const double own_h = h / placement.scale;
    const TriangleShape seen{own_light, own_eye, own_eye + end / placement.scale * own_w};
    part.query(seen, [&](std::uint32_t i) {
      Ends ends;
      const std::optional<Segment> whole =
          cross_section(part.triangle(i), own_light, own_w, own_y, own_normal, ends);
      if (!whole) return;
      const auto hide = [&](Segment s) {
        if (!clip(s, touching * own_h, (1.0 - touching) * own_h)) return;
        const double a = std::atan2(s[0].x, s[0].y);
        const double b = std::atan2(s[1].x, s[1].y);
        const double begin = std::max(std::min(a, b), first);
        const double stop = std::min(std::max(a, b), last);
        if (begin < stop) hidden.emplace_back(begin, stop);
      };
      if (!part.coverage.has_holes()) {
        hide(*whole);
        return;
      }
      each_solid_part([&](double at) { return part.is_hole(i, glm::mix(ends[0], ends[1], at)); },
                      [&](double begin, double stop) {
                        hide({glm::mix((*whole)[0], (*whole)[1], begin),
                              glm::mix((*whole)[0], (*whole)[1], stop)});
                      });
    });
  };
  bvh_.query(TriangleShape{light, eye, eye + end * w}, [&](std::uint32_t i) {
    hide_part(*parts_[instances_[i].part], instances_[i].placement);
  });
  std::sort(hidden.begin(), hidden.end());

  std::vector<std::pair<double, double>> lit;
  const auto t = [&](double angle) {
    return angle >= last ? end : std::clamp(ts + h * std::tan(angle), 0.0, end);
  };
  double lit_begin = first;
  const auto add_lit_until = [&](double angle) {
    if (lit_begin < angle && t(lit_begin) < t(angle)) lit.emplace_back(t(lit_begin), t(angle));
  };
  for (const auto& [begin, stop] : hidden) {
    add_lit_until(begin);
    lit_begin = std::max(lit_begin, stop);
  }
  add_lit_until(last);
  return lit;
}

}  // namespace brume
