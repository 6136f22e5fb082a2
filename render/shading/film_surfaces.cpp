#include "render/shading/film_surfaces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/ext/vector_int2.hpp>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/simd/surface_kernels.h"

namespace brume {
namespace {

// The work of one thread.
class Shader {
 public:
  Shader(const FilmSurfaces& film, std::span<const RasterPixel> hits,
         std::span<const std::uint32_t> copies, std::span<glm::vec3> radiance)
      : film_(film),
        hits_(hits),
        copies_(copies),
        radiance_(radiance),
        waiting_(film.surfaces.size()) {}

  void shade(const CameraRays::PixelRectangle& tile) {
    Tiles::each_pixel(tile, [&](int x, int y) {
      const std::size_t i = index_of({x, y});
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
    pairs_ += film_.shade(std::span(hits).first(pixels.size()),
                          std::span(seen_along).first(pixels.size()),
                          std::span(offsets).first(film_.rays.is_parallel() ? pixels.size() : 0),
                          std::span(outgoing).first(pixels.size()));
    for (std::size_t k = 0; k < pixels.size(); ++k) radiance_[index_of(pixels[k])] = outgoing[k];
    pixels.clear();
  }

  const FilmSurfaces& film_;
  std::span<const RasterPixel> hits_;
  std::span<const std::uint32_t> copies_;
  std::span<glm::vec3> radiance_;
  std::vector<std::vector<glm::ivec2>> waiting_;  // per surface
  std::uint64_t pairs_ = 0;
};

}  // namespace

std::uint64_t FilmSurfaces::shade(std::span<const SurfaceHit> hits,
                                  std::span<const glm::vec3> directions,
                                  std::span<const glm::dvec3> offsets,
                                  std::span<glm::vec3> radiance) const {
  return shade(hits, rays.eye(), directions, offsets, mirrored ? mirrored_rays : 0, radiance);
}

std::uint64_t FilmSurfaces::shade(std::span<const SurfaceHit> hits, const glm::dvec3& origin,
                                  std::span<const glm::vec3> directions,
                                  std::span<const glm::dvec3> offsets, int max_mirrored,
                                  std::span<glm::vec3> radiance) const {
  SurfacePoints points;
  points.pixel_angle = static_cast<float>(2.0 * rays.pixel_half_angle());
  points.pixel_width = static_cast<float>(rays.pixel_width());
  ray_caster.points(hits, origin, directions, offsets, surfaces, points);
  const Material& material = points.surface->material;
  const bool is_ggx = material.type == Material::Type::metallic_roughness;
  const bool mirrors = max_mirrored > 0 && is_ggx && may_mirror(material.metallic_roughness) &&
                       begin_mirroring(points);
  const SurfaceShading& shaded = shading.surfaces()[static_cast<std::size_t>(hits[0].surface)];
  // The light that transfer does not hold.
  const SurfaceLighting straight{.lights = lighting.lights};
  PointRadiance outgoing;
  std::uint64_t pairs =
      surface_radiance(medium, ray_caster, shaded.transferred ? straight : lighting, shaded, points,
                       precision, outgoing);
  if (shaded.transferred) shaded.transferred->add(hits, points, outgoing);
  if (mirrors) {
    const int next_mirrored = max_mirrored > few_mirrored_rays ? few_mirrored_rays : 0;
    const ShadeHits shade_hits = [&](auto mirrored_hits, const auto& center, auto seen_along,
                                     auto starts, auto seen) {
      pairs += shade(mirrored_hits, center, seen_along, starts, next_mirrored, seen);
    };
    add_mirrored_light({ray_caster, shading.environment(), mirrored->airlight_along,
                        mirrored->open_length, shade_hits},
                       points, max_mirrored, outgoing);
  }
  for (std::size_t k = 0; k < hits.size(); ++k) {
    radiance[k] = {outgoing.r[k], outgoing.g[k], outgoing.b[k]};
  }
  return pairs;
}

std::uint64_t FilmSurfaces::shade(std::span<const RasterPixel> hits,
                                  std::span<const std::uint32_t> copies, const Job& job,
                                  std::span<glm::vec3> radiance) const {
  const int columns = (pixels.x1 - pixels.x0 + block_width - 1) / block_width;
  const int rows = (pixels.y1 - pixels.y0 + block_height - 1) / block_height;
  std::atomic<std::uint64_t> pairs = 0;
  job.parallel_for(static_cast<std::size_t>(columns * rows), [&](std::size_t block) {
    const int left = pixels.x0 + static_cast<int>(block) % columns * block_width;
    const int top = pixels.y0 + static_cast<int>(block) / columns * block_height;
    const int right = std::min(left + block_width, pixels.x1);
    const int bottom = std::min(top + block_height, pixels.y1);
    Shader shader(*this, hits, copies, radiance);
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
  return pairs;
}

}  // namespace brume
