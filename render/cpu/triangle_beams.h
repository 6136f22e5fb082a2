#pragma once

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

 private:
  class Beam;
  struct Margins {
    double offset = 0.0;     // of shadow rays from their triangle [u]
    double tolerance = 0.0;  // of what float takes for a hit [u]
    double ends = 0.0;       // that surfaces keep to count, from where a ray starts or ends [u]
  };

  [[nodiscard]] bool is_clear(const Beam& beam) const;
  [[nodiscard]] bool is_covered(const Beam& beam, const PlacedTriangle& triangle) const;
  [[nodiscard]] bool is_covered(const Beam& beam, std::uint32_t triangle) const;

  const Visibility& visibility_;
  std::vector<PlacedTriangle> triangles_;
  TriangleHierarchy hierarchy_;
  // Across the edges from each corner to the next; see neighbours_of().
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  Margins margins_;
};

}  // namespace brume
