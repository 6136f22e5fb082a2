#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "brume/scene.h"
#include "core/scene/materials/coverage.h"
#include "core/scene/mesh.h"
#include "core/scene/placement.h"
#include "render/geometry/sphere_bvh.h"

namespace brume {

// Exact occlusion between a point light and a view ray. Where Embree traces one shadow ray, this
// evaluates all shadow rays from the light to the view ray analytically: in the plane of light and
// ray every triangle is a segment that hides an angular interval at the light, or where it has
// holes several. Panes count as opaque.
class ExactOcclusion {
 public:
  explicit ExactOcclusion(std::span<const Surface> surfaces);

  [[nodiscard]] bool empty() const { return instances_.empty(); }

  // The intervals [t0, t1] of the view ray eye + t w, t in [0, end], that are visible from the
  // light, ascending. Thread-safe.
  [[nodiscard]] std::vector<std::pair<double, double>> lit(const glm::dvec3& light,
                                                           const glm::dvec3& eye,
                                                           const glm::dvec3& w, double end) const;

 private:
  using Triangle = std::array<glm::dvec3, 3>;
  // The triangles of a surface: in the world, or in its mesh where it has copies.
  struct Part {
    std::shared_ptr<const TriangleMesh> mesh;
    Placement placement;
    std::vector<glm::dvec3> points;    // placed; empty: there are too many
    std::vector<std::uint32_t> order;  // of triangles: neighbours form groups
    Coverage coverage;
    SphereBvh bvh;  // of groups

    Part(const Surface& surface, const Placement& placement);
    [[nodiscard]] glm::dvec3 point(std::uint32_t vertex) const {
      return points.empty() ? placement.point_to_world(glm::dvec3(mesh->points[vertex]))
                            : points[vertex];
    }
    [[nodiscard]] Triangle triangle(std::uint32_t index) const;
    // Calls visit(index) for the triangles of all groups that a shape touches.
    void query(const auto& shape, auto visit) const;
    [[nodiscard]] bool is_hole(std::uint32_t triangle, const glm::dvec3& weights) const;
    // Stops the ray at the nearest hit.
    void shorten(const glm::dvec3& origin, const glm::dvec3& direction, double& end) const;
  };
  struct Instance {
    std::uint32_t part;
    Placement placement;
  };
  [[nodiscard]] double first_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                                 double end) const;

  std::vector<std::unique_ptr<const Part>> parts_;
  std::vector<Instance> instances_;
  SphereBvh bvh_;  // of instances
};

}  // namespace brume
