#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "render/scattering/environment_light.h"
#include "render/shading/shared_highlights.h"
#include "render/simd/surface_points.h"
#include "render/visibility/light_shapes.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Light that smooth surfaces mirror: what the rays of a highlight meet, as view rays do. Rougher
// ones reflect the spherical harmonics of all light, which hold no more. Lights that are seen end
// rays, and show nothing: what the surface reflects of the lights themselves, their points and
// add_area_highlight() have already, whether they are seen or not.

// Airlight and optical depth of rays from neighbouring points, at `offsets` from the origin, in
// unit directions up to `lengths` (may be +inf).
using AirlightAlong =
    std::function<void(const glm::dvec3& origin, std::span<const glm::dvec3> offsets,
                       std::span<const glm::dvec3> directions, std::span<const double> lengths,
                       std::span<glm::vec3> airlight, std::span<double> depths)>;

// Radiance, towards where the rays start, of hits of one surface: rays from `origin` plus offsets,
// in unit directions; up to Tiles::pixels of them.
using ShadeHits =
    std::function<void(std::span<const SurfaceHit> hits, const glm::dvec3& origin,
                       std::span<const glm::vec3> directions, std::span<const glm::dvec3> offsets,
                       std::span<glm::vec3> radiance)>;

// The scene as mirrored rays meet it.
struct MirroredScene {
  const RayCaster& ray_caster;
  const LightShapes& light_shapes;
  const EnvironmentLight* environment;                                 // null: none
  const AirlightAlong& airlight_along;                                 // empty: there is no medium
  const std::function<double(const glm::dvec3& origin)>& open_length;  // of rays that hit nothing
  const ShadeHits& shade;
};

// Takes the highlight from what spherical harmonics reflect at points that mirror; see
// GgxPoints::lobe. Whether there are any.
bool begin_mirroring(SurfacePoints& points);

// Which rays points mirror.
struct MirroredRays {
  int max_rays = 1;  // of a point
  // Points whose wide highlights are shared mirror a pattern of SharedHighlights::pattern_of(), and
  // `none` nothing. Empty: all mirror the same rays.
  std::span<const std::uint8_t> patterns{};
  static constexpr std::uint8_t none = 255;
  static constexpr int shared_rays = 4;
  int pattern_rays = shared_rays;  // of a pattern; a power of two
};

// Whether a highlight is so wide that neighbours can share its rays.
bool is_wide_highlight(float alpha);

// Highlights of points that are shared.
struct WideHighlights {
  PointRadiance base{}, grazing{};

  [[nodiscard]] Highlight operator[](std::size_t k) const { return {base[k], grazing[k]}; }
};

// radiance += what points reflect from mirrored rays: they are spread over the highlight, by the
// normals that the eye sees; one where it is narrow. Wide highlights of points with patterns go to
// `shared` instead. Thread-safe.
void add_mirrored_light(const MirroredScene& scene, const SurfacePoints& points,
                        const MirroredRays& mirrored, PointRadiance& radiance,
                        WideHighlights* shared = nullptr);

}  // namespace brume
