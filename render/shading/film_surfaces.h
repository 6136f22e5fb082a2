#pragma once

#include <array>
#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/scene/camera_rays.h"
#include "render/geometry/medium_index.h"
#include "render/geometry/tiles.h"
#include "render/settings.h"
#include "render/shading/mirrored_light.h"
#include "render/shading/prepared_shading.h"
#include "render/shading/shared_highlights.h"
#include "render/shading/surface_shading.h"
#include "render/util/job.h"
#include "render/visibility/light_shapes.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// How far mirrored rays go, and what is on their way.
struct MirroredWays {
  AirlightAlong airlight_along;                                 // empty: there is no medium
  std::function<double(const glm::dvec3& origin)> open_length;  // of rays that hit nothing
};

// Shades the surfaces of a view.
struct FilmSurfaces {
  // Pixels of a block are looked at by one thread, and their points shaded together: whether a
  // shadow ray grazes a triangle may depend on the rays beside it.
  static constexpr int block_width = 4 * Tiles::width;
  static constexpr int block_height = 4 * Tiles::height;

  std::span<const Surface> surfaces;
  const MediumIndex& medium;
  const RayCaster& ray_caster;
  const PreparedShading& shading;
  const SurfaceLighting& lighting;
  const CameraRays& rays;
  Film film;
  CameraRays::PixelRectangle pixels;  // those that are shaded, whole blocks
  Settings::Precision precision;
  const LightShapes& light_shapes;
  const MirroredWays* mirrored = nullptr;  // null: nothing mirrors
  bool is_mirrored_alone = false;          // see Settings::mirrored_alone
  // Rays that a point mirrors at most; their hits mirror few_mirrored_rays, and the hits of these
  // none.
  static constexpr int mirrored_rays = 16;
  static constexpr int few_mirrored_rays = 2;

  // Sets the exitant radiance of these pixels' hits towards the eye, of surfaces or lights, black
  // where there is none.
  // `copies`: see SurfaceHit; empty: nothing has copies. Returns the Gaussian x path pairs
  // evaluated, and what wide highlights reflect.
  std::uint64_t shade(std::span<const RasterPixel> hits, std::span<const std::uint32_t> copies,
                      const Job& job, std::span<glm::vec3> radiance,
                      SharedHighlights& shared) const;
  // The same of a hit on a light.
  [[nodiscard]] glm::vec3 radiance_of_light(const SurfaceHit& hit) const {
    return is_mirrored_alone ? glm::vec3(0.0f) : light_shapes.of(hit).radiance;
  }
  // The same of up to Tiles::pixels hits on one surface, seen in these unit directions; from
  // `offsets`, unless empty, see RayCaster::first_hits().
  std::uint64_t shade(std::span<const SurfaceHit> hits, std::span<const glm::vec3> directions,
                      std::span<const glm::dvec3> offsets, std::span<glm::vec3> radiance) const;
  // The same of samples of pixels, whose highlights may be known, where not null; others mirror a
  // pattern of their own each.
  struct Samples {
    std::span<const glm::ivec2> seen_in;
    std::span<const std::size_t> numbers;  // within their pixels
    std::size_t count;                     // of a pixel's
  };
  std::uint64_t shade(std::span<const SurfaceHit> hits, std::span<const glm::vec3> directions,
                      std::span<const glm::dvec3> offsets, const Samples& samples,
                      const std::array<const SharedHighlights*, 2>& known,
                      std::span<glm::vec3> radiance) const;
  // The same of pixels, without wide highlights, which go to `shared`.
  std::uint64_t shade(std::span<const SurfaceHit> hits, std::span<const glm::vec3> directions,
                      std::span<const glm::dvec3> offsets, std::span<const glm::ivec2> seen_in,
                      std::span<glm::vec3> radiance, SharedHighlights& shared) const;

 private:
  // Points that are lit, and what they reflect without mirrored rays.
  struct Lit {
    SurfacePoints points;
    PointRadiance outgoing;
    bool mirrors = false;
    std::uint64_t pairs = 0;
  };
  void light(std::span<const SurfaceHit> hits, const glm::dvec3& origin,
             std::span<const glm::vec3> directions, std::span<const glm::dvec3> offsets,
             bool may_mirror_rays, Lit& lit) const;
  // The same of what the eye sees; without light where only what they mirror is shown.
  void light_seen(std::span<const SurfaceHit> hits, std::span<const glm::vec3> directions,
                  std::span<const glm::dvec3> offsets, Lit& lit) const;
  // The parts of light(): where points are and whether they mirror, and what else they reflect.
  void find_points(std::span<const SurfaceHit> hits, const glm::dvec3& origin,
                   std::span<const glm::vec3> directions, std::span<const glm::dvec3> offsets,
                   bool may_mirror_rays, Lit& lit) const;
  void reflect(std::span<const SurfaceHit> hits, Lit& lit) const;
  // Adds what they mirror; `wide`: see add_mirrored_light().
  void mirror(const MirroredRays& rays_of_points, Lit& lit, WideHighlights* wide = nullptr) const;
};

}  // namespace brume
