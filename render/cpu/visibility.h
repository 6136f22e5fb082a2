#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>

#include "core/scene/scene.h"

namespace brume {

// Where a ray meets the first surface.
struct SurfaceHit {
  double distance = 0.0;
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};            // unit, interpolated, on the side the ray comes from
  glm::dvec3 geometric_normal{0.0};  // unit, of the triangle, on the side the ray comes from
  // Where shadow rays start: off the triangle by a few roundings of float, and out to the smooth
  // surface that the normals describe, so that coarse triangles cast no shadow on themselves
  // (Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021).
  glm::dvec3 shadow_origin{0.0};
  const Surface* surface = nullptr;
};

// The surfaces of a scene for ray casting, by Embree. Coordinates go to Embree in float relative
// to the middle of the surfaces, so a scene far from the origin loses nothing.
class Visibility {
 public:
  explicit Visibility(std::span<const Surface> surfaces);
  ~Visibility();
  Visibility(const Visibility&) = delete;
  Visibility& operator=(const Visibility&) = delete;

  [[nodiscard]] bool empty() const;

  // Whether surfaces() still are these, mesh by mesh and place by place (materials do not count).
  [[nodiscard]] bool shows(std::span<const Surface> surfaces) const;

  // The nearest hit of a ray (unit direction). Thread-safe.
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const glm::dvec3& origin,
                                                    const glm::dvec3& direction,
                                                    std::span<const Surface> surfaces) const;

  // Whether a surface stands between two points, ends excluded. Thread-safe.
  [[nodiscard]] bool blocked(const glm::dvec3& from, const glm::dvec3& to) const;

  // Whether any surface could stand between the light and the segment from a to b: false only if
  // all surfaces are away from that triangle.
  [[nodiscard]] bool may_block(const glm::dvec3& light, const glm::dvec3& a,
                               const glm::dvec3& b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace brume
