#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/ext/vector_uint3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "render/geometry/box.h"
#include "render/geometry/rounding.h"
#include "render/simd/surface_points.h"
#include "render/visibility/raster.h"
#include "render/visibility/surface_hit.h"
#include "render/visibility/surface_point.h"

namespace brume {

// A pane on a ray, and the share of light that it lets through.
struct PaneHit {
  SurfaceHit hit;
  double passing = 1.0;
};

// The hits on a ray: panes by distance, and the first surface that lets nothing through.
struct HitsOnRay {
  std::vector<PaneHit> panes;
  SurfaceHit end;

  // The share of light that comes through as far as that.
  [[nodiscard]] double passing(double distance) const;
};

// A pane where it is seen.
struct SeenPane {
  double covered = 1.0;  // share of what it reflects and emits that is there
  double passing = 0.0;  // of light in the channels of the ray caster
  double opaque = 1.0;   // share of light that does not pass, all channels together
};

// A triangle in world space, relative to Visibility::center().
struct WorldTriangle {
  std::array<glm::vec3, 3> positions;
  std::array<glm::vec3, 3> normals;  // of any length
  glm::uvec3 vertices{0};            // in the surface's mesh
  std::uint32_t surface = 0;
  std::uint32_t index = 0;  // in the surface's mesh
};

// Ray casting against the surfaces of a scene, by Embree. Coordinates are stored as float relative
// to coordinate_center(), so scenes far from the origin lose no precision. Rays pass holes. Panes
// are hit unless a function says something else.
class RayCaster {
 public:
  // `channels`: weights of red, green and blue in what panes let through.
  static constexpr glm::dvec3 all_channels{1.0 / 3.0};
  explicit RayCaster(std::span<const Surface> surfaces, const glm::dvec3& channels = all_channels);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  [[nodiscard]] Revision revision() const { return revision_; }
  [[nodiscard]] bool empty() const;
  [[nodiscard]] std::size_t size() const;  // triangles, without those of copies
  // Bounds of all surfaces.
  [[nodiscard]] const Box& bounds() const;
  // Bounds of one surface; low > high if it has no points.
  [[nodiscard]] const Box& surface_bounds(std::size_t surface) const;

  // Data for casting the same rays elsewhere: the center that triangles are relative to, the radius
  // of the ball around it that holds them all (< 0: none), and the triangles without those of
  // copies.
  [[nodiscard]] const glm::dvec3& center() const;
  [[nodiscard]] double radius() const;
  [[nodiscard]] std::vector<WorldTriangle> triangles() const;
  // The same one by one.
  void for_each_triangle(const std::function<void(const WorldTriangle&)>& visit) const;
  [[nodiscard]] std::uint32_t index_of(const SurfaceHit& hit) const;  // index in triangles()
  // Whether rays may start here: close enough that rounding the direction moves a hit by a few
  // float roundings only. Rays from farther away start near the ball.
  [[nodiscard]] bool is_near(const glm::dvec3& origin) const;
  // Those within so many radii of the ball, and where others start, in its radii.
  static constexpr double near_radii = 8.0;
  static constexpr double start_radii = 1.01;
  // Shadow rays end this share of their length before the light, which may lie on a surface.
  static constexpr double light_margin = 2.0 * position_rounding;

  // Whether these are the surfaces it was built from, comparing meshes, placements, holes and panes
  // (other values of materials do not count).
  [[nodiscard]] bool shows(std::span<const Surface> surfaces,
                           const glm::dvec3& channels = all_channels) const;
  [[nodiscard]] bool has_panes() const;

  // The nearest hit of a ray (unit direction); triangles seen edge-on are invisible
  // (render/geometry/edge_on.h). Thread-safe.
  [[nodiscard]] SurfaceHit first_hit(const glm::dvec3& origin, const glm::dvec3& direction) const;

  // The same for coherent rays, several times as fast. Ignores hits nearer than `nearest`.
  void first_hits(const glm::dvec3& origin, std::span<const glm::dvec3> directions,
                  std::span<SurfaceHit> hits, double nearest = 0.0) const;

  // The same for view rays, from their clipping planes on. Parallel ones start at `offsets` from
  // the eye, and see no triangle that lies along them; without offsets all start at the eye.
  void first_hits(const CameraRays& rays, std::span<const glm::dvec3> directions,
                  std::span<const glm::dvec3> offsets, std::span<SurfaceHit> hits) const;
  // That of a view ray through a position on the film.
  [[nodiscard]] SurfaceHit first_hit(const CameraRays& rays, double x, double y) const;

  // The same as the first of these through panes: hits of what lets nothing through.
  void opaque_hits(const glm::dvec3& origin, std::span<const glm::dvec3> directions,
                   std::span<SurfaceHit> hits, double nearest) const;

  // All hits on a ray but those nearer than `nearest`. Thread-safe.
  [[nodiscard]] HitsOnRay hits_on_ray(const glm::dvec3& origin, const glm::dvec3& direction,
                                      double nearest = 0.0) const;
  // A first hit that passes each pane by chance, as often as light does; `draw` returns numbers in
  // [0, 1), and is called only where there are panes.
  [[nodiscard]] SurfaceHit first_hit_by_chance(const glm::dvec3& origin,
                                               const glm::dvec3& direction,
                                               const std::function<double()>& draw) const;
  // The hit behind one on a pane. Thread-safe.
  [[nodiscard]] SurfaceHit next_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                                    const SurfaceHit& before) const;
  // Whether a hit is on a surface that lets light through somewhere.
  [[nodiscard]] bool is_pane(const SurfaceHit& hit) const;
  // The pane at a hit that is seen over so many u; opaque where it is no pane.
  [[nodiscard]] SeenPane pane(const SurfaceHit& hit, double width) const;
  // The weight of the light that a pane reflects where it stops rays as often as light.
  [[nodiscard]] double reflected_by_chance(const SurfaceHit& hit) const;

  // Rasterization of a pinhole's first hits: precise enough unless the eye is far away. Nothing
  // may have copies. Keeps a reference to this.
  [[nodiscard]] bool can_rasterize(const CameraRays& rays) const;
  [[nodiscard]] Raster raster(const CameraRays& rays, const Film& film, const Job& job) const;
  // Those and hits on lights as pixels, and pixels as hits.
  [[nodiscard]] SurfaceHit hit_of(const RasterPixel& pixel, std::uint32_t copy = 0) const;
  [[nodiscard]] RasterPixel pixel_of(const SurfaceHit& hit) const;

  // The hit point of that ray; textures are not averaged. Thread-safe.
  [[nodiscard]] SurfacePoint point(const SurfaceHit& hit, const glm::dvec3& origin,
                                   const glm::dvec3& direction,
                                   std::span<const Surface> surfaces) const;

  // The same for hits on one surface, in single precision relative to the center. Textures are
  // averaged over what is a pixel wide there, as if it met the surface in a circle. `offsets`: see
  // first_hits(). Thread-safe.
  void points(std::span<const SurfaceHit> hits, const glm::dvec3& origin,
              std::span<const glm::vec3> directions, std::span<const glm::dvec3> offsets,
              std::span<const Surface> surfaces, SurfacePoints& points) const;

  // Sets `lit`, the share of light that comes through, of a light at `position` relative to
  // points.origin that point_to_light() has seen.
  void trace_shadow_rays(const SurfacePoints& points, const glm::vec3& position,
                         LightAtPoints& light) const;

  // The share of light that surfaces let through between two points, ends excluded. Thread-safe.
  [[nodiscard]] double transmittance(const glm::dvec3& start, const glm::dvec3& end) const;
  // The same along a ray, which sees no triangle edge-on.
  [[nodiscard]] double transmittance(const glm::dvec3& origin, const glm::dvec3& direction,
                                     double length) const;
  // Whether that is less than half.
  [[nodiscard]] bool occluded(const glm::dvec3& start, const glm::dvec3& end) const {
    return transmittance(start, end) < 0.5;
  }

 private:
  Revision revision_ = new_revision();
  // `parallel`: the direction of the rays beside it.
  [[nodiscard]] SurfaceHit cast(const glm::dvec3& origin, const glm::dvec3& direction,
                                const std::optional<glm::dvec3>& parallel, double nearest) const;
  // `nearest`: a number, or a function of the start and direction of a ray.
  void cast(const glm::dvec3& eye, std::span<const glm::dvec3> directions,
            std::span<const glm::dvec3> offsets, std::span<SurfaceHit> hits, const auto& nearest,
            bool passes_panes = false) const;
  void cast_shadow_rays(const SurfacePoints& points, const glm::vec3& position,
                        std::span<const std::uint8_t> pending, LightAtPoints& light) const;

  // Sets points.ggx and turns normals.
  void find_materials(std::span<const SurfaceHit> hits, SurfacePoints& points) const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// One of these surfaces: that which something still holds, or else a new one.
std::shared_ptr<const RayCaster> shared_ray_caster(
    std::span<const Surface> surfaces, const glm::dvec3& channels = RayCaster::all_channels);

}  // namespace brume
