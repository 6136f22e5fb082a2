#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/cpu/visibility.h"
#include "render/triangle_hierarchy.h"

namespace brume {

// What a light sees of the points of a triangle that face it.
enum class TriangleSight : std::uint8_t {
  unknown,
  whole,    // all of them
  none,     // other surfaces stand before all of them
  in_part,  // or it cannot be told in short
};

// Of one side only: what is seen of the other one may be another matter where the triangle is
// turned away from the light, but smoothed normals are not.
struct SideSight {
  TriangleSight of_points = TriangleSight::unknown;
  std::int8_t side = 1;  // as SurfacePoints::side
};

// A triangle cut into equal ones, so many times along each edge.
struct TrianglePart {
  static constexpr int along = 4;
  static constexpr std::uint32_t count = 2 * along * along;  // numbers; half of them are none

  static bool exists(std::uint32_t part) {
    return part / 2 / along + part / 2 % along + part % 2 < along;
  }
  // The number of the part that holds a point, by its barycentric coordinates.
  static std::uint32_t at(float u, float v) {
    const int i = std::clamp(static_cast<int>(u * along), 0, along - 1);
    const int j = std::clamp(static_cast<int>(v * along), 0, along - 1 - i);
    const bool is_upper = i + j < along - 1 && (u + v) * along > static_cast<float>(i + j + 1);
    return static_cast<std::uint32_t>(2 * (i * along + j) + (is_upper ? 1 : 0));
  }
};

// All shadow rays between one triangle and one light at once, which fill a beam: the convex hull of
// the light and of where the rays start (SurfacePoint::shadow_origin).
class TriangleBeams {
 public:
  // Refers to `visibility`.
  explicit TriangleBeams(const Visibility& visibility);

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }

  // Of the side that the light is on; never unknown. `whole` and `none` are what
  // Visibility::find_lit() finds by rays. `light` is relative to Visibility::middle(), `triangle`
  // an index in Visibility::triangles(). Thread-safe.
  [[nodiscard]] SideSight sight(const glm::dvec3& light, std::uint32_t triangle) const;
  // The same of a part of it.
  [[nodiscard]] TriangleSight sight_of_part(const glm::dvec3& light, std::uint32_t triangle,
                                            std::uint32_t part) const;

 private:
  class Beam;
  struct Margins {
    double offset = 0.0;     // of shadow rays from their triangle [u]
    double tolerance = 0.0;  // of what float takes for a hit [u]
    double ends = 0.0;       // that surfaces keep to count, from where a ray starts or ends [u]
  };

  [[nodiscard]] TriangleSight sight(const Beam& beam) const;
  [[nodiscard]] TriangleSight sight_of_parts(const glm::dvec3& light, std::uint32_t triangle) const;
  [[nodiscard]] bool is_clear(const Beam& beam) const;
  [[nodiscard]] bool is_covered(const Beam& beam) const;
  [[nodiscard]] bool is_covered(const Beam& beam, std::uint32_t triangle) const;

  const Visibility& visibility_;
  std::vector<PlacedTriangle> triangles_;
  TriangleHierarchy hierarchy_;
  // Across the edges from each corner to the next; see neighbours_of().
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  Margins margins_;
};

}  // namespace brume
