#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace brume {

// A tree of bounding spheres over spheres, to find in O(log n + k) the k of n spheres that a ray,
// a bundle of rays or a triangle touches. Built in O(n log n), in parallel.
class SphereHierarchy {
 public:
  SphereHierarchy() = default;
  // Spheres of radius <= 0 are left out: nothing touches them.
  SphereHierarchy(std::span<const glm::dvec3> centers, std::span<const double> radii);

  // Calls visit(index) for every sphere that shape.touches(center, radius); may answer for a
  // sphere more than the shape touches if touches() is conservative.
  template <class Shape, class Visit>
  void query(const Shape& shape, Visit visit) const {
    if (nodes_.empty()) return;
    std::uint32_t stack[64];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      if (!shape.touches(node.center, node.radius)) continue;
      if (node.count > 0) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
          if (shape.touches(centers_[i], radii_[i])) visit(indices_[i]);
        }
      } else {
        stack[top++] = node.first;
        stack[top++] = node.second;
      }
    }
  }

 private:
  struct Node {
    glm::dvec3 center{0.0};
    double radius = 0.0;
    std::uint32_t first = 0;   // leaf: first sphere; else: one child
    std::uint32_t second = 0;  // the other child
    std::uint32_t count = 0;   // of spheres in a leaf, 0 otherwise
  };
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t count);
  void fit(Node& node, std::uint32_t first, std::uint32_t count) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> indices_;
  // In the order of the leaves.
  std::vector<glm::dvec3> centers_;
  std::vector<double> radii_;
};

// The segment of a ray from an origin, up to a distance that may be +inf, and what is within
// `width` of it.
struct RaySegment {
  glm::dvec3 origin;
  glm::dvec3 direction;  // unit
  double length;
  double width = 0.0;

  [[nodiscard]] bool touches(const glm::dvec3& center, double radius) const {
    const glm::dvec3 q = center - origin;
    const double t = glm::clamp(glm::dot(q, direction), 0.0, length);
    const glm::dvec3 gap = q - t * direction;
    const double near = radius + width;
    return glm::dot(gap, gap) <= near * near;
  }
};

// Rays from one origin within an angle around an axis, up to a distance. touches() is
// conservative by rounding only.
class RayBundle {
 public:
  // The narrowest such bundle around segments from `origin` to `ends`.
  RayBundle(const glm::dvec3& origin, std::span<const glm::dvec3> ends);

  [[nodiscard]] bool touches(const glm::dvec3& center, double radius) const;

 private:
  glm::dvec3 origin_;
  glm::dvec3 axis_{0.0, 0.0, 1.0};
  double cos_ = 1.0;  // of the half angle
  double sin_ = 0.0;
  double far_ = 0.0;
};

// The triangle between a point and a segment (light and view ray).
struct TriangleShape {
  glm::dvec3 a, b, c;

  [[nodiscard]] bool touches(const glm::dvec3& center, double radius) const;
};

}  // namespace brume
