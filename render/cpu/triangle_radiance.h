#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/cpu/lamp_sights.h"
#include "render/cpu/radiance_patch.h"
#include "render/cpu/surface_points.h"
#include "render/cpu/visibility.h"

namespace brume {

struct SurfaceLight;

// The radiance that diffuse triangles send, kept from frame to frame while surfaces and light stay:
// it is the same for every view. Kept are triangles that every lamp sees all or nothing of, as
// quadratic patches; where those are close enough, a look-up stands for all shading.
class TriangleRadiance {
 public:
  // How far a patch may be off, as a share of the greatest radiance at a triangle's corners: below
  // half of a step of an 8-bit picture.
  static constexpr float tolerance = 1.0f / 512.0f;
  static constexpr std::uint32_t rounds = LampSights::rounds;

  explicit TriangleRadiance(std::size_t triangles) : triangles_(triangles) {}

  // `eye` is relative to Visibility::middle(), `triangle` an index in Visibility::triangles().
  // Null: it has to be shaded.
  [[nodiscard]] const RadiancePatch* of(std::uint32_t triangle, const glm::vec3& eye) const {
    const Triangle& t = triangles_[triangle];
    return t.state == State::kept && t.faces(eye) ? &t.patch : nullptr;
  }

  // Before of() is asked for many.
  void prefetch(std::uint32_t triangle) const { __builtin_prefetch(&triangles_[triangle]); }

  // Before the points of every frame after the first are asked about.
  void begin_frame() { ++frame_; }
  // In the order of LampSights, which have to be known first: whether this frame is to find out
  // about the side of a triangle that the eye sees.
  [[nodiscard]] bool is_due(std::uint32_t triangle, const glm::vec3& eye) const {
    if (triangle % rounds != frame_ % rounds) return false;
    const Triangle& t = triangles_[triangle];
    return t.state == State::unknown || !t.faces(eye);
  }

  // Where on a triangle its radiance is asked for: at corners and middles of edges, which a patch
  // goes through, and at where a cubic is farthest from it.
  static constexpr std::size_t probes = 10;
  static constexpr std::array<glm::vec2, probes> probe_places{{{0.0f, 0.0f},
                                                               {1.0f, 0.0f},
                                                               {0.0f, 1.0f},
                                                               {0.5f, 0.0f},
                                                               {0.5f, 0.5f},
                                                               {0.0f, 0.5f},
                                                               {1.0f / 3, 1.0f / 3},
                                                               {1.0f / 6, 1.0f / 6},
                                                               {2.0f / 3, 1.0f / 6},
                                                               {1.0f / 6, 2.0f / 3}}};
  // Keeps what the probes tell of their triangles, all of one surface. Thread-safe for different
  // triangles while no others are asked about.
  void keep(const SurfacePoints& points, std::span<const SurfaceLight> lights,
            const PointRadiance& radiance);

 private:
  enum class State : std::uint8_t { unknown, kept, not_kept };
  struct alignas(64) Triangle {
    RadiancePatch patch;
    // Seen is the side where dot(normal, eye) > offset.
    glm::vec3 normal{0.0f};
    float offset = 0.0f;
    State state = State::unknown;

    [[nodiscard]] bool faces(const glm::vec3& eye) const { return glm::dot(normal, eye) > offset; }
  };
  static_assert(sizeof(Triangle) == 64);

  std::uint32_t frame_ = 0;
  std::vector<Triangle> triangles_;
};

}  // namespace brume
