#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace brume {

// A bounding-sphere hierarchy over spheres: finds the k of n spheres that a ray, a bundle of rays
// or a triangle touches in O(log n + k). Built in parallel in O(n log n).
class SphereBvh {
 public:
  SphereBvh() = default;
  // Spheres of radius <= 0 are ignored.
  SphereBvh(std::span<const glm::dvec3> centers, std::span<const double> radii);

  // Calls visit(index) for every sphere for which shape.touches(center, radius). May report more if
  // touches() is conservative.
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
  class Builder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> indices_;
  // In leaf order.
  std::vector<glm::dvec3> centers_;
  std::vector<double> radii_;
};

// A ray segment (length may be +inf), thickened by `width`.
struct RaySegment {
  glm::dvec3 origin;
  glm::dvec3 direction;  // unit
  double length;
  double width = 0.0;

  [[nodiscard]] bool touches(const glm::dvec3& center, double radius) const {
    const glm::dvec3 q = center - origin;
    const double t = glm::clamp(glm::dot(q, direction), 0.0, length);
    const glm::dvec3 offset = q - t * direction;
    const double near = radius + width;
    return glm::dot(offset, offset) <= near * near;
  }
};

// A cone of rays from one origin, up to a distance. touches() is conservative by rounding only.
class RayBundle {
 public:
  // The narrowest bundle that contains the segments from `origin` to `endpoints`.
  RayBundle(const glm::dvec3& origin, std::span<const glm::dvec3> endpoints);

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
