#include "render/film_surfaces.h"

#include <array>
#include <atomic>

#include "render/cpu/surface_kernels.h"
#include "render/tiles.h"

namespace brume {
namespace {

// Points of one surface.
struct Seen {
  std::array<SurfaceHit, Tiles::pixels> hits;
  std::array<glm::vec3, Tiles::pixels> directions;
  std::array<std::size_t, Tiles::pixels> pixels;
  std::size_t count = 0;
};

// Sets the radiance of their pixels.
std::uint64_t shade_points(const FilmSurfaces& film, const Seen& seen,
                           std::span<glm::vec3> radiance) {
  const auto hits = std::span(seen.hits).first(seen.count);
  SurfacePoints points;
  film.visibility.points(hits, std::span(seen.directions).first(seen.count), film.surfaces, points);
  const SurfaceShading& shading =
      film.shading.surfaces()[static_cast<std::size_t>(hits[0].surface)];
  // What transfer does not hold.
  const SurfaceLighting straight{.lights = film.lighting.lights};
  PointRadiance sent;
  const std::uint64_t pairs =
      surface_radiance(film.medium, film.visibility, shading.transferred ? straight : film.lighting,
                       shading, points, film.arithmetic, sent);
  if (shading.transferred) shading.transferred->add(hits, points, sent);
  for (std::size_t k = 0; k < seen.count; ++k) {
    radiance[seen.pixels[k]] = {sent.r[k], sent.g[k], sent.b[k]};
  }
  return pairs;
}

}  // namespace

std::uint64_t FilmSurfaces::shade(std::span<const SurfaceHit> hits, const Job& job,
                                  std::span<glm::vec3> radiance) const {
  const Tiles tiles(film);
  const auto width = static_cast<std::size_t>(film.width);
  std::atomic<std::uint64_t> pairs = 0;
  job.each(tiles.count(), [&](std::size_t tile) {
    const CameraRays::PixelRectangle rectangle = tiles.rectangle(tile);
    PointVectors directions;
    find_view_directions(rays, rectangle, directions);
    // What is not shaded yet: places in the tile, and their pixels.
    struct Left {
      std::size_t place, pixel;
    };
    std::array<Left, Tiles::pixels> left;
    std::size_t count = 0;
    std::size_t place = 0;
    Tiles::each_pixel(rectangle, [&](int x, int y) {
      const std::size_t i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      radiance[i] = glm::vec3(0.0f);
      if (hits[i]) left[count++] = {place, i};
      ++place;
    });
    while (count > 0) {
      const std::int32_t surface = hits[left[0].pixel].surface;
      Seen seen;
      std::size_t others = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const auto [at, pixel] = left[k];
        if (hits[pixel].surface != surface) {
          left[others++] = left[k];
          continue;
        }
        seen.hits[seen.count] = hits[pixel];
        seen.directions[seen.count] = {directions.x[at], directions.y[at], directions.z[at]};
        seen.pixels[seen.count++] = pixel;
      }
      pairs += shade_points(*this, seen, radiance);
      count = others;
    }
  });
  return pairs;
}

}  // namespace brume
