#include "render/geometry/sphere_bvh.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brume {
namespace {

constexpr std::uint32_t leaf_size = 4;

// Node count of a balanced binary tree over `count` spheres, so subtrees can be built in parallel
// at known positions.
std::uint32_t node_count(std::uint32_t count) {
  if (count <= leaf_size) return 1;
  const std::uint32_t half = count / 2;
  return 1 + node_count(half) + node_count(count - half);
}

}  // namespace

// Sorts the spheres into the order of the leaves, and fits the nodes.
class SphereBvh::Builder {
 public:
  struct Sphere {
    glm::dvec3 center;
    double radius;
    std::uint32_t index;
  };

  Builder(std::span<Sphere> spheres, std::vector<Node>& nodes) : spheres_(spheres), nodes_(nodes) {}

  void build() { build(0, 0, static_cast<std::uint32_t>(spheres_.size())); }

 private:
  struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& from, const glm::dvec3& to) {
      low = glm::min(low, from);
      high = glm::max(high, to);
    }
  };

  // Returns the spheres' bounds.
  Box build(std::uint32_t index, std::uint32_t first, std::uint32_t count) {
    Node& node = nodes_[index];
    const std::span<Sphere> own = spheres_.subspan(first, count);
    Box box;
    if (count <= leaf_size) {
      node.first = first;
      node.count = count;
      for (const Sphere& s : own) box.add(s.center - s.radius, s.center + s.radius);
      fit_spheres(node, box, own);
      return box;
    }
    const std::uint32_t half = count / 2;
    split(own, half);
    const std::uint32_t left = index + 1;
    const std::uint32_t right = left + node_count(half);
    node.first = left;
    node.second = right;
    Box of_left, of_right;
    const auto build_left = [&] { of_left = build(left, first, half); };
    const auto build_right = [&] { of_right = build(right, first + half, count - half); };
    if (count > 1024) {
      tbb::parallel_invoke(build_left, build_right);
    } else {
      build_left();
      build_right();
    }
    box = of_left;
    box.add(of_right.low, of_right.high);
    // Tightly where queries end; above, about the children, which takes no pass over all spheres.
    constexpr std::uint32_t tight = 64;
    if (count <= tight) {
      fit_spheres(node, box, own);
    } else {
      node.center = 0.5 * (box.low + box.high);
      for (const std::uint32_t child : {left, right}) {
        const Node& part = nodes_[child];
        node.radius = std::max(node.radius, glm::length(part.center - node.center) + part.radius);
      }
      node.radius = std::min(node.radius, glm::length(box.high - node.center));
    }
    return box;
  }

  static void fit_spheres(Node& node, const Box& box, std::span<const Sphere> own) {
    node.center = 0.5 * (box.low + box.high);
    for (const Sphere& s : own) {
      node.radius = std::max(node.radius, glm::length(s.center - node.center) + s.radius);
    }
  }

  // At the median of the longest axis of the centers.
  static void split(std::span<Sphere> own, std::uint32_t half) {
    Box box;
    for (const Sphere& s : own) box.add(s.center, s.center);
    const glm::dvec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    std::nth_element(own.begin(), own.begin() + half, own.end(),
                     [axis](const Sphere& a, const Sphere& b) {
                       // The index breaks ties, so that the tree is the same every time.
                       return a.center[axis] != b.center[axis] ? a.center[axis] < b.center[axis]
                                                               : a.index < b.index;
                     });
  }

  std::span<Sphere> spheres_;
  std::vector<Node>& nodes_;
};

SphereBvh::SphereBvh(std::span<const glm::dvec3> centers, std::span<const double> radii) {
  std::vector<Builder::Sphere> spheres;
  spheres.reserve(centers.size());
  for (std::uint32_t i = 0; i < centers.size(); ++i) {
    if (radii[i] > 0.0) spheres.push_back({centers[i], radii[i], i});
  }
  if (spheres.empty()) return;
  nodes_.resize(node_count(static_cast<std::uint32_t>(spheres.size())));
  Builder(spheres, nodes_).build();
  indices_.reserve(spheres.size());
  centers_.reserve(spheres.size());
  radii_.reserve(spheres.size());
  for (const Builder::Sphere& s : spheres) {
    indices_.push_back(s.index);
    centers_.push_back(s.center);
    radii_.push_back(s.radius);
  }
}

RayBundle::RayBundle(const glm::dvec3& origin, std::span<const glm::dvec3> endpoints)
    : origin_(origin) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& endpoint : endpoints) {
    const glm::dvec3 q = endpoint - origin;
    const double distance = glm::length(q);
    far_ = std::max(far_, distance);
    if (distance > 0.0) sum += q / distance;
  }
  const double length = glm::length(sum);
  if (length > 0.0) axis_ = sum / length;
  for (const glm::dvec3& endpoint : endpoints) {
    const glm::dvec3 q = endpoint - origin;
    const double distance = glm::length(q);
    if (distance > 0.0) cos_ = std::min(cos_, glm::dot(q, axis_) / distance);
  }
  // A cosine near 1 has lost half the digits of its angle: widen by more than that.
  cos_ = std::max(cos_ - 1e-14, -1.0);
  sin_ = std::sqrt(std::max(1.0 - cos_ * cos_, 0.0));
}

bool RayBundle::touches(const glm::dvec3& center, double radius) const {
  const glm::dvec3 q = center - origin_;
  const double distance2 = glm::dot(q, q);
  if (distance2 <= radius * radius) return true;
  const double distance = std::sqrt(distance2);
  if (distance - radius > far_) return false;
  // angle(q, axis) <= half angle + asin(radius / distance), without inverse functions.
  const double sin_sphere = radius / distance;
  const double cos_sphere = std::sqrt(1.0 - sin_sphere * sin_sphere);
  if (sin_ * cos_sphere + cos_ * sin_sphere < 0.0) return true;  // the sum is beyond pi
  const double limit = cos_ * cos_sphere - sin_ * sin_sphere;
  return glm::dot(q, axis_) >= limit * distance;
}

bool TriangleShape::touches(const glm::dvec3& center, double radius) const {
  // The closest point of a triangle, by the region of its plane that the centre is over.
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 ap = center - a;
  const auto near_edge = [&](const glm::dvec3& from, const glm::dvec3& edge) {
    const double length2 = glm::dot(edge, edge);
    const glm::dvec3 q = center - from;
    const double t = length2 > 0.0 ? glm::clamp(glm::dot(q, edge) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec3 offset = q - t * edge;
    return glm::dot(offset, offset) <= radius * radius;
  };
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double area2 = glm::dot(normal, normal);
  if (area2 > 0.0) {
    const double u = glm::dot(glm::cross(ap, ac), normal);
    const double v = glm::dot(glm::cross(ab, ap), normal);
    if (u >= 0.0 && v >= 0.0 && u + v <= area2) {
      const double height = glm::dot(ap, normal);
      return height * height <= radius * radius * area2;
    }
  }
  return near_edge(a, ab) || near_edge(a, ac) || near_edge(b, c - b);
}

}  // namespace brume
