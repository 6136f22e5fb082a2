#pragma once

#include <atomic>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/cpu/triangle_beams.h"

namespace brume {

// How much a lamp sees of each triangle, and of the parts of those that it sees in part. While lamp
// and surfaces stay, every frame finds out about some of the triangles that it shows: one frame for
// itself does nothing, and a few frames pay for the shadow rays that those after them save.
class LampSights {
 public:
  // `lamp` as in TriangleBeams::sight(). Refers to `beams`.
  LampSights(const TriangleBeams& beams, const glm::dvec3& lamp);

  // Before the points of a frame are asked about.
  void begin_frame() { ++frame_; }
  // Of the points of a triangle that are seen from this side, as SurfacePoints::side. Thread-safe.
  [[nodiscard]] TriangleSight of(std::uint32_t triangle, float side) const {
    SideSight sight = sights_[triangle].load(std::memory_order_relaxed);
    if (sight.of_points == TriangleSight::unknown) sight = find(triangle);
    const bool is_of_side = static_cast<float>(sight.side) == side;
    return is_of_side || sight.of_points == TriangleSight::unknown ? sight.of_points
                                                                   : TriangleSight::in_part;
  }
  // The same of one point's surroundings, by its barycentric coordinates.
  [[nodiscard]] TriangleSight of(std::uint32_t triangle, float side, float u, float v) const {
    const TriangleSight sight = of(triangle, side);
    if (sight != TriangleSight::in_part) return sight;
    // Turned the other way, it is in part for good.
    if (static_cast<float>(sights_[triangle].load(std::memory_order_relaxed).side) != side)
      return sight;
    const std::uint32_t part = TrianglePart::at(u, v);
    const auto known = static_cast<TriangleSight>(
        parts_[triangle].load(std::memory_order_relaxed) >> 2 * part & 3);
    return known == TriangleSight::unknown ? find_part(triangle, part) : known;
  }

  static constexpr std::uint32_t rounds = 8;  // frames after which all triangles are known
  // What finding out about a part costs. It is done when as many rays have been cast for a triangle
  // since the last one, so that parts never cost more than what they may save.
  static constexpr std::uint32_t rays_per_part = 32;

 private:
  SideSight find(std::uint32_t triangle) const;
  TriangleSight find_part(std::uint32_t triangle, std::uint32_t part) const;

  const TriangleBeams& beams_;
  glm::dvec3 lamp_;
  std::uint32_t frame_ = 0;
  mutable std::vector<std::atomic<SideSight>> sights_;
  // Two bits for each part: its TriangleSight.
  mutable std::vector<std::atomic<std::uint64_t>> parts_;
  static_assert(2 * TrianglePart::count <= 64);
  mutable std::vector<std::atomic<std::uint16_t>> asked_;  // for points of unknown parts
  static_assert((1 << 16) % rays_per_part == 0);
};

}  // namespace brume
