#include "render/film_surfaces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/ext/vector_int2.hpp>
#include <mutex>
#include <vector>

#include "render/cpu/surface_kernels.h"
#include "render/tiles.h"

namespace brume {
namespace {

// So many neighbours are looked at by one thread, and their points shaded together.
constexpr std::size_t tiles_together = 25;

// Points of one surface.
struct Seen {
  std::array<SurfaceHit, Tiles::pixels> hits;
  std::array<glm::vec3, Tiles::pixels> directions;
  std::size_t count = 0;
};

// Sets the radiance that they send.
std::uint64_t shade_points(const FilmSurfaces& film, const Seen& seen, SurfacePoints& points,
                           PointRadiance& sent) {
  const auto hits = std::span(seen.hits).first(seen.count);
  film.visibility.points(hits, std::span(seen.directions).first(seen.count), film.surfaces, points);
  const SurfaceShading& shading =
      film.shading.surfaces()[static_cast<std::size_t>(hits[0].surface)];
  // What transfer does not hold.
  const SurfaceLighting straight{.lights = film.lighting.lights};
  const std::uint64_t pairs =
      surface_radiance(film.medium, film.visibility, shading.transferred ? straight : film.lighting,
                       shading, points, film.arithmetic, sent);
  if (shading.transferred) shading.transferred->add(hits, points, sent);
  return pairs;
}

bool is_same_from_everywhere(const FilmSurfaces& film, std::int32_t surface) {
  const auto s = static_cast<std::size_t>(surface);
  const ShMaterial* material = film.shading.surfaces()[s].material;
  return film.surfaces[s].material.type == Material::Type::diffuse &&
         (!material || material->is_diffuse());
}

// Pixels of a tile whose triangles are kept.
class Known {
 public:
  void add(std::size_t pixel, const RadiancePatch& patch, const glm::vec2& uv) {
    pixels_[count_] = pixel;
    patches_[count_] = &patch;
    uv_[count_++] = uv;
  }

  void look_up(std::span<glm::vec3> radiance) const {
    std::array<glm::vec3, Tiles::pixels> sent;
    evaluate_patches(std::span(patches_).first(count_), std::span(uv_).first(count_), sent);
    for (std::size_t k = 0; k < count_; ++k) radiance[pixels_[k]] = sent[k];
  }

 private:
  std::array<std::size_t, Tiles::pixels> pixels_;
  std::array<const RadiancePatch*, Tiles::pixels> patches_;
  std::array<glm::vec2, Tiles::pixels> uv_;
  std::size_t count_ = 0;
};

// A triangle that is to be kept, and a direction in which it is seen.
struct Asked {
  std::uint32_t triangle;
  glm::vec3 direction;
};

// What one thread does.
class Shader {
 public:
  Shader(const FilmSurfaces& film, std::span<const RasterPixel> hits, std::span<glm::vec3> radiance)
      : film_(film),
        hits_(hits),
        radiance_(radiance),
        eye_(film.rays.eye() - film.visibility.middle()),
        waiting_(film.surfaces.size()) {}

  void shade(const CameraRays::PixelRectangle& tile) {
    std::array<glm::ivec2, Tiles::pixels> pixels;
    std::size_t count = 0;
    Tiles::each_pixel(tile, [&](int x, int y) {
      const std::size_t i = index_of({x, y});
      radiance_[i] = glm::vec3(0.0f);
      if (!std::isfinite(hits_[i].distance)) return;
      pixels[count++] = {x, y};
      // Asked for all of a tile before the first is read.
      if (film_.kept) film_.kept->prefetch(hits_[i].triangle);
    });
    Known known;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = index_of(pixels[k]);
      const RasterPixel& hit = hits_[i];
      const RadiancePatch* patch = film_.kept ? film_.kept->of(hit.triangle, eye_) : nullptr;
      if (patch) {
        known.add(i, *patch, {hit.u, hit.v});
      } else {
        shade_later(pixels[k]);
      }
    }
    known.look_up(radiance_);
  }

  // Before the tile is shaded: its rows are far apart in memory.
  void prefetch(const CameraRays::PixelRectangle& tile) const {
    constexpr int per_line = 64 / sizeof(RasterPixel);
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; x += per_line) {
        __builtin_prefetch(&hits_[index_of({x, y})]);
      }
    }
  }

  // Shades what has waited until now.
  void finish() {
    for (std::vector<glm::ivec2>& pixels : waiting_) shade_now(pixels);
  }

  [[nodiscard]] std::uint64_t pairs() const { return pairs_; }
  [[nodiscard]] const std::vector<Asked>& asked() const { return asked_; }

 private:
  [[nodiscard]] std::size_t index_of(const glm::ivec2& pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(film_.film.width) +
           static_cast<std::size_t>(pixel.x);
  }

  void shade_later(const glm::ivec2& pixel) {
    const SurfaceHit hit = film_.visibility.hit_of(hits_[index_of(pixel)]);
    std::vector<glm::ivec2>& pixels = waiting_[static_cast<std::size_t>(hit.surface)];
    pixels.push_back(pixel);
    if (pixels.size() == Tiles::pixels) shade_now(pixels);
  }

  // Pixels that see one surface.
  void shade_now(std::vector<glm::ivec2>& pixels) {
    if (pixels.empty()) return;
    Seen seen;
    PointVectors directions;
    find_view_directions(film_.rays, pixels, directions);
    for (const glm::ivec2& pixel : pixels) {
      const std::size_t k = seen.count++;
      seen.hits[k] = film_.visibility.hit_of(hits_[index_of(pixel)]);
      seen.directions[k] = {directions.x[k], directions.y[k], directions.z[k]};
    }
    SurfacePoints points;
    PointRadiance sent;
    pairs_ += shade_points(film_, seen, points, sent);
    for (std::size_t k = 0; k < seen.count; ++k) {
      radiance_[index_of(pixels[k])] = {sent.r[k], sent.g[k], sent.b[k]};
    }
    pixels.clear();
    if (!film_.kept || !is_same_from_everywhere(film_, seen.hits[0].surface)) return;
    for (std::size_t k = 0; k < seen.count; ++k) {
      if (film_.kept->is_due(points.triangle[k], eye_)) {
        asked_.push_back({points.triangle[k], seen.directions[k]});
      }
    }
  }

  const FilmSurfaces& film_;
  std::span<const RasterPixel> hits_;
  std::span<glm::vec3> radiance_;
  glm::vec3 eye_;
  std::vector<std::vector<glm::ivec2>> waiting_;  // per surface
  std::uint64_t pairs_ = 0;
  std::vector<Asked> asked_;
};

// The probes of as many triangles as fill a tile, of one surface each.
std::vector<Seen> probes_of(const std::vector<Asked>& asked, const Visibility& visibility) {
  constexpr std::size_t probes = TriangleRadiance::probes;
  std::vector<Seen> batches;
  for (const Asked& of : asked) {
    const auto hit_at = [&](const glm::vec2& place) {
      return visibility.hit_of({0.0f, of.triangle, place.x, place.y});
    };
    const bool fits = !batches.empty() && batches.back().count + probes <= Tiles::pixels &&
                      batches.back().hits[0].surface == hit_at({}).surface;
    if (!fits) batches.emplace_back();
    Seen& seen = batches.back();
    for (const glm::vec2& place : TriangleRadiance::probe_places) {
      seen.hits[seen.count] = hit_at(place);
      seen.directions[seen.count++] = of.direction;
    }
  }
  return batches;
}

}  // namespace

std::uint64_t FilmSurfaces::shade(std::span<const RasterPixel> hits, const Job& job,
                                  std::span<glm::vec3> radiance) const {
  const Tiles tiles(film);
  std::atomic<std::uint64_t> pairs = 0;
  std::mutex mutex;
  std::vector<Asked> asked;
  job.each((tiles.count() + tiles_together - 1) / tiles_together, [&](std::size_t part) {
    Shader shader(*this, hits, radiance);
    const std::size_t end = std::min((part + 1) * tiles_together, tiles.count());
    for (std::size_t tile = part * tiles_together; tile < end; ++tile) {
      shader.shade(tiles.rectangle(tile));
      if (tile + 1 < end) shader.prefetch(tiles.rectangle(tile + 1));
    }
    shader.finish();
    pairs += shader.pairs();
    const std::lock_guard lock(mutex);
    asked.insert(asked.end(), shader.asked().begin(), shader.asked().end());
  });
  std::ranges::sort(asked, {}, &Asked::triangle);
  const auto again = std::ranges::unique(asked, {}, &Asked::triangle);
  asked.erase(again.begin(), again.end());
  const std::vector<Seen> batches = probes_of(asked, visibility);
  job.each(batches.size(), [&](std::size_t b) {
    SurfacePoints points;
    PointRadiance sent;
    pairs += shade_points(*this, batches[b], points, sent);
    kept->keep(points, lighting.lights, sent);
  });
  return pairs;
}

}  // namespace brume
