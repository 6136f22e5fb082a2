#include "render/film_surfaces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/ext/vector_int2.hpp>
#include <mutex>
#include <utility>

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

// Pixels that see one surface and wait until they fill a batch.
struct Waiting {
  std::array<glm::ivec2, Tiles::pixels> pixels;
  std::size_t count = 0;
};

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

// Rows of a tile are far apart in memory.
void prefetch(std::span<const RasterPixel> hits, const CameraRays::PixelRectangle& tile,
              int width) {
  constexpr int per_line = 64 / sizeof(RasterPixel);
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; x += per_line) {
      __builtin_prefetch(&hits[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x)]);
    }
  }
}

}  // namespace

std::uint64_t FilmSurfaces::shade(std::span<const RasterPixel> hits, const Job& job,
                                  std::span<glm::vec3> radiance) const {
  const Tiles tiles(film);
  const glm::vec3 eye(rays.eye() - visibility.middle());
  const auto index_of = [width = film.width](const glm::ivec2& pixel) {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(pixel.x);
  };
  std::atomic<std::uint64_t> pairs = 0;
  std::mutex mutex;
  std::vector<Asked> asked;
  job.each((tiles.count() + tiles_together - 1) / tiles_together, [&](std::size_t part) {
    std::vector<Asked> unknown;
    const auto shade_all = [&](Waiting& waiting) {
      if (waiting.count == 0) return;
      Seen seen;
      seen.count = waiting.count;
      PointVectors directions;
      find_view_directions(rays, std::span(waiting.pixels).first(waiting.count), directions);
      for (std::size_t k = 0; k < seen.count; ++k) {
        seen.hits[k] = visibility.hit_of(hits[index_of(waiting.pixels[k])]);
        seen.directions[k] = {directions.x[k], directions.y[k], directions.z[k]};
      }
      SurfacePoints points;
      PointRadiance sent;
      pairs += shade_points(*this, seen, points, sent);
      const bool keeps = kept && is_same_from_everywhere(seen.hits[0].surface);
      for (std::size_t k = 0; k < seen.count; ++k) {
        radiance[index_of(waiting.pixels[k])] = {sent.r[k], sent.g[k], sent.b[k]};
        if (keeps && kept->is_due(points.triangle[k], eye)) {
          unknown.push_back({points.triangle[k], seen.directions[k]});
        }
      }
      waiting.count = 0;
    };
    std::vector<Waiting> waiting(surfaces.size());
    const std::size_t end = std::min((part + 1) * tiles_together, tiles.count());
    for (std::size_t tile = part * tiles_together; tile < end; ++tile) {
      if (tile + 1 < end) {
        const auto next = tiles.rectangle(tile + 1);
        for (int y = next.y0; y < next.y1; ++y) for (int x = next.x0; x < next.x1; x += 4) __builtin_prefetch(&hits[index_of({x, y})]);
      }
      std::array<glm::ivec2, Tiles::pixels> pixels;
      std::size_t count = 0;
      Tiles::each_pixel(tiles.rectangle(tile), [&](int x, int y) {
        const std::size_t i = index_of({x, y});
        radiance[i] = glm::vec3(0.0f);
        if (!std::isfinite(hits[i].distance)) return;
        pixels[count++] = {x, y};
        // Asked for all of a tile before the first is read.
        if (kept) kept->prefetch(hits[i].triangle);
      });
      Known known;
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = index_of(pixels[k]);
        const RasterPixel& hit = hits[i];
        if (const RadiancePatch* patch = kept ? kept->of(hit.triangle, eye) : nullptr) {
          known.add(i, *patch, {hit.u, hit.v});
          continue;
        }
        Waiting& of = waiting[static_cast<std::size_t>(visibility.hit_of(hit).surface)];
        of.pixels[of.count++] = pixels[k];
        if (of.count == of.pixels.size()) shade_all(of);
      }
      known.look_up(radiance);
      if (tile + 1 < end) prefetch(hits, tiles.rectangle(tile + 1), film.width);
    }
    for (Waiting& of : waiting) shade_all(of);
    const std::lock_guard lock(mutex);
    asked.insert(asked.end(), unknown.begin(), unknown.end());
  });
  if (!asked.empty()) pairs += find_out(std::move(asked), job);
  return pairs;
}

bool FilmSurfaces::is_same_from_everywhere(std::int32_t surface) const {
  const auto s = static_cast<std::size_t>(surface);
  const ShMaterial* material = shading.surfaces()[s].material;
  return surfaces[s].material.type == Material::Type::diffuse && (!material || material->is_diffuse());
}

std::uint64_t FilmSurfaces::find_out(std::vector<Asked> asked, const Job& job) const {
  std::ranges::sort(asked, {}, &Asked::triangle);
  const auto again = std::ranges::unique(asked, {}, &Asked::triangle);
  asked.erase(again.begin(), again.end());
  // As many triangles of one surface as fill a tile with their probes, of one surface each.
  constexpr std::size_t most = Tiles::pixels / TriangleRadiance::probes;
  std::vector<Seen> batches;
  for (const Asked& of : asked) {
    const auto hit_at = [&](const glm::vec2& place) {
      return visibility.hit_of({0.0f, of.triangle, place.x, place.y});
    };
    const bool fits = !batches.empty() && batches.back().count < most * TriangleRadiance::probes &&
                      batches.back().hits[0].surface == hit_at({}).surface;
    if (!fits) batches.emplace_back();
    Seen& seen = batches.back();
    for (const glm::vec2& place : TriangleRadiance::probe_places) {
      seen.hits[seen.count] = hit_at(place);
      seen.directions[seen.count++] = of.direction;
    }
  }
  std::atomic<std::uint64_t> pairs = 0;
  job.each(batches.size(), [&](std::size_t b) {
    SurfacePoints points;
    PointRadiance sent;
    pairs += shade_points(*this, batches[b], points, sent);
    kept->keep(points, lighting.lights, sent);
  });
  return pairs;
}

}  // namespace brume
