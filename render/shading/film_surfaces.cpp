#include "render/shading/film_surfaces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "render/simd/surface_kernels.h"

namespace brume {
namespace {

// The work of one thread.
class Shader {
 public:
  Shader(const FilmSurfaces& film, std::span<const RasterPixel> hits,
         std::span<const std::uint32_t> copies, std::span<glm::vec3> radiance,
         SharedHighlights& shared, bool are_lonely)
      : film_(film),
        hits_(hits),
        copies_(copies),
        radiance_(radiance),
        shared_(shared),
        are_lonely_(are_lonely),
        waiting_(film.surfaces.size()) {}

  void shade(const CameraRays::PixelRectangle& tile) {
    Tiles::each_pixel(tile, [&](int x, int y) {
      const std::size_t i = index_of({x, y});
      if (are_lonely_ && !shared_.is_lonely({x, y})) return;
      radiance_[i] = glm::vec3(0.0f);
      if (std::isfinite(hits_[i].distance)) shade_later({x, y});
    });
  }

  // Before tiles are shaded: their rows are far apart in memory.
  void prefetch(const CameraRays::PixelRectangle& tiles) const {
    constexpr int per_line = 64 / sizeof(RasterPixel);
    for (int y = tiles.y0; y < tiles.y1; ++y) {
      for (int x = tiles.x0; x < tiles.x1; x += per_line) {
        __builtin_prefetch(&hits_[index_of({x, y})]);
      }
    }
  }

  // Shades what has waited until now.
  void finish() {
    for (std::vector<glm::ivec2>& pixels : waiting_) shade_now(pixels);
  }

  [[nodiscard]] std::uint64_t pairs() const { return pairs_; }

 private:
  [[nodiscard]] std::size_t index_of(const glm::ivec2& pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(film_.film.width) +
           static_cast<std::size_t>(pixel.x);
  }

  [[nodiscard]] SurfaceHit hit_of(const glm::ivec2& pixel) const {
    const std::size_t i = index_of(pixel);
    return film_.ray_caster.hit_of(hits_[i], copies_.empty() ? 0 : copies_[i]);
  }

  void shade_later(const glm::ivec2& pixel) {
    const SurfaceHit hit = hit_of(pixel);
    if (hit.is_light()) {
      radiance_[index_of(pixel)] = film_.radiance_of_light(hit);
      return;
    }
    std::vector<glm::ivec2>& pixels = waiting_[static_cast<std::size_t>(hit.surface)];
    pixels.push_back(pixel);
    if (pixels.size() == Tiles::pixels) shade_now(pixels);
  }

  // Pixels that see one surface.
  void shade_now(std::vector<glm::ivec2>& pixels) {
    if (pixels.empty()) return;
    std::array<SurfaceHit, Tiles::pixels> hits;
    std::array<glm::vec3, Tiles::pixels> seen_along, outgoing;
    std::array<glm::dvec3, Tiles::pixels> offsets;
    PointVectors directions;
    find_view_directions(film_.rays, pixels, directions);
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      hits[k] = hit_of(pixels[k]);
      seen_along[k] = {directions.x[k], directions.y[k], directions.z[k]};
      offsets[k] = film_.rays.offset(pixels[k].x + 0.5, pixels[k].y + 0.5);
    }
    const std::size_t count = pixels.size();
    const auto own_hits = std::span(hits).first(count);
    const auto own_directions = std::span(seen_along).first(count);
    const auto own_offsets = std::span(offsets).first(film_.rays.is_parallel() ? count : 0);
    const auto own_radiance = std::span(outgoing).first(count);
    pairs_ += are_lonely_ ? film_.shade(own_hits, own_directions, own_offsets, own_radiance)
                          : film_.shade(own_hits, own_directions, own_offsets, pixels, own_radiance,
                                        shared_);
    for (std::size_t k = 0; k < pixels.size(); ++k) radiance_[index_of(pixels[k])] = outgoing[k];
    pixels.clear();
  }

  const FilmSurfaces& film_;
  std::span<const RasterPixel> hits_;
  std::span<const std::uint32_t> copies_;
  std::span<glm::vec3> radiance_;
  SharedHighlights& shared_;
  bool are_lonely_;  // those of its pixels that have no share are shaded, not all
  std::vector<std::vector<glm::ivec2>> waiting_;  // per surface
  std::uint64_t pairs_ = 0;
};

}  // namespace

void FilmSurfaces::find_points(std::span<const SurfaceHit> hits, const glm::dvec3& origin,
                               std::span<const glm::vec3> directions,
                               std::span<const glm::dvec3> offsets, bool may_mirror_rays,
                               Lit& lit) const {
  lit.points.pixel_angle = static_cast<float>(2.0 * rays.pixel_half_angle());
  lit.points.pixel_width = static_cast<float>(rays.pixel_width());
  ray_caster.points(hits, origin, directions, offsets, surfaces, lit.points);
  const Material& material = lit.points.surface->material;
  lit.mirrors = may_mirror_rays && material.type == Material::Type::metallic_roughness &&
                may_mirror(material.metallic_roughness) && begin_mirroring(lit.points);
}

void FilmSurfaces::reflect(std::span<const SurfaceHit> hits, Lit& lit) const {
  const SurfaceShading& shaded = shading.surfaces()[static_cast<std::size_t>(hits[0].surface)];
  // The light that transfer does not hold.
  const SurfaceLighting straight{.lights = lighting.lights};
  lit.pairs = surface_radiance(medium, ray_caster, shaded.transferred ? straight : lighting, shaded,
                               lit.points, precision, lit.outgoing);
  if (shaded.transferred) shaded.transferred->add(hits, lit.points, lit.outgoing);
}

void FilmSurfaces::light(std::span<const SurfaceHit> hits, const glm::dvec3& origin,
                         std::span<const glm::vec3> directions, std::span<const glm::dvec3> offsets,
                         bool may_mirror_rays, Lit& lit) const {
  find_points(hits, origin, directions, offsets, may_mirror_rays, lit);
  reflect(hits, lit);
}

void FilmSurfaces::light_seen(std::span<const SurfaceHit> hits,
                              std::span<const glm::vec3> directions,
                              std::span<const glm::dvec3> offsets, Lit& lit) const {
  find_points(hits, rays.eye(), directions, offsets, mirrored != nullptr, lit);
  if (is_mirrored_alone) {
    lit.outgoing = {};
  } else {
    reflect(hits, lit);
  }
}

void FilmSurfaces::mirror(const MirroredRays& rays_of_points, Lit& lit,
                          WideHighlights* wide) const {
  const bool is_last = rays_of_points.max_rays <= few_mirrored_rays;
  const ShadeHits shade_hits = [&](auto mirrored_hits, const auto& center, auto seen_along,
                                   auto starts, auto seen) {
    Lit next;
    light(mirrored_hits, center, seen_along, starts, !is_last, next);
    if (next.mirrors) mirror({.max_rays = few_mirrored_rays}, next);
    for (std::size_t k = 0; k < mirrored_hits.size(); ++k) seen[k] = next.outgoing[k];
    lit.pairs += next.pairs;
  };
  add_mirrored_light({ray_caster, light_shapes, shading.environment(), mirrored->airlight_along,
                      mirrored->open_length, shade_hits},
                     lit.points, rays_of_points, lit.outgoing, wide);
}

std::uint64_t FilmSurfaces::shade(std::span<const SurfaceHit> hits,
                                  std::span<const glm::vec3> directions,
                                  std::span<const glm::dvec3> offsets,
                                  std::span<const glm::ivec2> seen_in,
                                  std::span<glm::vec3> radiance, SharedHighlights& shared) const {
  Lit lit;
  light_seen(hits, directions, offsets, lit);
  WideHighlights wide;
  if (lit.mirrors) {
    std::array<std::uint8_t, Tiles::pixels> patterns;
    for (std::size_t k = 0; k < hits.size(); ++k) {
      patterns[k] = SharedHighlights::pattern_of(rays.first_pixel() + seen_in[k]);
    }
    mirror({mirrored_rays, std::span(patterns).first(hits.size())}, lit, &wide);
  }
  for (std::size_t k = 0; k < hits.size(); ++k) {
    radiance[k] = lit.outgoing[k];
    const float alpha = lit.points.ggx.alpha[k];
    if (!lit.mirrors || lit.points.ggx.lobe[k] > 0.0f || !is_wide_highlight(alpha)) continue;
    shared.set(seen_in[k], {hits[k].surface, hits[k].copy, alpha, lit.points.normal[k],
                            lit.points.ggx.f0[k], wide[k]});
  }
  return lit.pairs;
}

std::uint64_t FilmSurfaces::shade(std::span<const SurfaceHit> hits,
                                  std::span<const glm::vec3> directions,
                                  std::span<const glm::dvec3> offsets,
                                  std::span<glm::vec3> radiance) const {
  Lit lit;
  light_seen(hits, directions, offsets, lit);
  if (lit.mirrors) mirror({mirrored_rays}, lit);
  for (std::size_t k = 0; k < hits.size(); ++k) radiance[k] = lit.outgoing[k];
  return lit.pairs;
}

std::uint64_t FilmSurfaces::shade(std::span<const SurfaceHit> hits,
                                  std::span<const glm::vec3> directions,
                                  std::span<const glm::dvec3> offsets, const Samples& samples,
                                  const std::array<const SharedHighlights*, 2>& known,
                                  std::span<glm::vec3> radiance) const {
  Lit lit;
  light_seen(hits, directions, offsets, lit);
  if (lit.mirrors) {
    std::array<std::uint8_t, Tiles::pixels> patterns;
    for (std::size_t k = 0; k < hits.size(); ++k) {
      const glm::ivec2& pixel = samples.seen_in[k];
      // An odd step, so that all patterns have their turn.
      constexpr std::size_t step = 13;
      patterns[k] = static_cast<std::uint8_t>(
          (SharedHighlights::pattern_of(rays.first_pixel() + pixel) + step * samples.numbers[k]) %
          SharedHighlights::patterns);
      if (lit.points.ggx.lobe[k] > 0.0f || !is_wide_highlight(lit.points.ggx.alpha[k])) continue;
      const Highlight* found = nullptr;
      for (const SharedHighlights* each : known) {
        if (each && !found) found = each->find(pixel, hits[k], lit.points.normal[k]);
      }
      if (!found) continue;
      patterns[k] = MirroredRays::none;
      lit.outgoing.add(k, found->reflected(lit.points.ggx.f0[k]));
    }
    // The only sample of a pixel mirrors as many rays as several do.
    const bool is_only = samples.count == 1;
    mirror({is_only ? mirrored_rays : few_mirrored_rays, std::span(patterns).first(hits.size()),
            is_only ? mirrored_rays : MirroredRays::shared_rays},
           lit);
  }
  for (std::size_t k = 0; k < hits.size(); ++k) radiance[k] = lit.outgoing[k];
  return lit.pairs;
}

std::uint64_t FilmSurfaces::shade(std::span<const RasterPixel> hits,
                                  std::span<const std::uint32_t> copies, const Job& job,
                                  std::span<glm::vec3> radiance, SharedHighlights& shared) const {
  shared.reset(mirrored ? glm::ivec2(film.width, film.height) : glm::ivec2(0),
               static_cast<float>(2.0 * rays.pixel_half_angle()));
  const int columns = (pixels.x1 - pixels.x0 + block_width - 1) / block_width;
  const int rows = (pixels.y1 - pixels.y0 + block_height - 1) / block_height;
  std::atomic<std::uint64_t> pairs = 0;
  const auto shade_blocks = [&](bool are_lonely) {
    job.parallel_for(static_cast<std::size_t>(columns * rows), [&](std::size_t block) {
      const int left = pixels.x0 + static_cast<int>(block) % columns * block_width;
      const int top = pixels.y0 + static_cast<int>(block) / columns * block_height;
      const int right = std::min(left + block_width, pixels.x1);
      const int bottom = std::min(top + block_height, pixels.y1);
      Shader shader(*this, hits, copies, radiance, shared, are_lonely);
      for (int y = top; y < bottom; y += Tiles::height) {
        for (int x = left; x < right; x += Tiles::width) {
          shader.shade(
              {x, y, std::min(x + Tiles::width, right), std::min(y + Tiles::height, bottom)});
        }
        const int next = y + Tiles::height;
        if (next < bottom) {
          shader.prefetch({left, next, right, std::min(next + Tiles::height, bottom)});
        }
      }
      shader.finish();
      pairs += shader.pairs();
    });
  };
  shade_blocks(false);
  if (!mirrored || job.stop.stop_requested()) return pairs;
  shared.share(pixels, job, radiance);
  shade_blocks(true);
  return pairs;
}

}  // namespace brume
