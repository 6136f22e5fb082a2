#pragma once

#include <array>
#include <cstdint>
#include <glm/ext/vector_uint3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "render/cpu/box.h"
#include "render/cpu/raster.h"
#include "render/cpu/surface_points.h"

namespace brume {

// The nearest surface on a ray, as little as is kept per pixel.
struct SurfaceHit {
  double distance = std::numeric_limits<double>::infinity();
  std::int32_t surface = -1;  // index, or -1 for none
  std::uint32_t triangle = 0;
  float u = 0.0f, v = 0.0f;  // barycentric, of the triangle's second and third corner

  explicit operator bool() const { return surface >= 0; }
};

// All that shading needs of a hit.
struct SurfacePoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  // unit, interpolated, on the side that is seen
  glm::dvec3 to_eye{0.0};  // unit
  // Where shadow rays start: off the triangle by a few roundings of float, and out to the smooth
  // surface that the normals describe, so that coarse triangles cast no shadow on themselves
  // (Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021).
  glm::dvec3 shadow_origin{0.0};
  const Surface* surface = nullptr;
};

// A triangle of a surface as rays meet it, relative to Visibility::middle().
struct PlacedTriangle {
  std::array<glm::vec3, 3> positions;
  std::array<glm::vec3, 3> normals;  // of any length
  glm::uvec3 vertices{0};            // in the surface's mesh
  std::uint32_t surface = 0;
  std::uint32_t index = 0;  // in the surface's mesh
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
  [[nodiscard]] std::size_t size() const;  // triangles
  // Around all surfaces.
  [[nodiscard]] const Box& bounds() const;

  // For who casts the same rays elsewhere: what triangles are relative to, the radius of the ball
  // around it that holds them all (< 0: there are none), and the triangles.
  [[nodiscard]] const glm::dvec3& middle() const;
  [[nodiscard]] double radius() const;
  [[nodiscard]] std::vector<PlacedTriangle> triangles() const;
  [[nodiscard]] std::uint32_t index_of(const SurfaceHit& hit) const;  // in triangles()
  // Whether rays may start at this point, so close that rounding a direction moves a hit by a few
  // roundings of float only; those from farther away start near the ball.
  [[nodiscard]] bool is_near(const glm::dvec3& origin) const;
  // Rays start and end this share of their length away from the surfaces they leave or reach, which
  // is a few roundings of float.
  static constexpr double self_hit_margin = 1e-5;

  // Whether surfaces() still are these, mesh by mesh and place by place (materials do not count).
  [[nodiscard]] bool shows(std::span<const Surface> surfaces) const;

  // The nearest hit of a ray (unit direction); triangles in whose plane it starts are not seen
  // (render/cpu/edge_on.h). Thread-safe.
  [[nodiscard]] SurfaceHit first_hit(const glm::dvec3& origin, const glm::dvec3& direction) const;

  // The same for rays that lie close to each other, several times as fast. Hits nearer than
  // `nearest` do not count.
  void first_hits(const glm::dvec3& origin, std::span<const glm::dvec3> directions,
                  std::span<SurfaceHit> hits, double nearest = 0.0) const;

  // What lies this near to where a ray starts may as well be on its other side: a few roundings of
  // float [u].
  [[nodiscard]] double least_gap() const;

  // The first hits of the view rays of a film at once, as a raster has them, which is faster than
  // rays where pixels are not far fewer than triangles, and has digits enough where the eye is not
  // far off. Refers to this.
  [[nodiscard]] bool suits_raster(const CameraRays& rays, const Film& film) const;
  [[nodiscard]] Raster raster(const CameraRays& rays, const Film& film, const Job& job) const;
  [[nodiscard]] SurfaceHit hit_of(const RasterPixel& pixel) const;
  [[nodiscard]] RasterPixel pixel_of(const SurfaceHit& hit) const;

  // The point where that ray hit. Thread-safe.
  [[nodiscard]] SurfacePoint point(const SurfaceHit& hit, const glm::dvec3& origin,
                                   const glm::dvec3& direction,
                                   std::span<const Surface> surfaces) const;

  // The same of hits on one surface, of rays of these directions, in single precision: positions
  // to 1e-6 of the size of all surfaces, relative to their middle. Thread-safe.
  void points(std::span<const SurfaceHit> hits, std::span<const glm::vec3> directions,
              std::span<const Surface> surfaces, SurfacePoints& points) const;

  // Sets `lit` of a light at `position` relative to points.origin that see_light() has seen.
  void find_lit(const SurfacePoints& points, const glm::vec3& position, LightAtPoints& light) const;

  // Whether a surface stands between two points, ends excluded. Thread-safe.
  [[nodiscard]] bool blocked(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  void cast_shadow_rays(const SurfacePoints& points, const glm::vec3& position,
                        std::span<const std::uint8_t> asked, LightAtPoints& light) const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace brume
