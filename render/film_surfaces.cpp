#include "render/film_surfaces.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "render/cpu/surface_kernels.h"
#include "render/tiles.h"

namespace brume {
namespace {

struct Seen {
  SurfaceHit hit;
  glm::vec3 direction;
  std::size_t pixel;
};

// Of one surface; sets the radiance of their pixels.
std::uint64_t shade_points(const FilmSurfaces& film, std::span<const Seen> seen,
                           std::span<glm::vec3> radiance) {
  std::array<SurfaceHit, Tiles::pixels> hits;
  std::array<glm::vec3, Tiles::pixels> directions;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    hits[k] = seen[k].hit;
    directions[k] = seen[k].direction;
  }
  const auto own_hits = std::span(hits).first(seen.size());
  SurfacePoints points;
  film.visibility.points(own_hits, std::span(directions).first(seen.size()), film.surfaces, points);
  const SurfaceShading& shading =
      film.shading.surfaces()[static_cast<std::size_t>(seen[0].hit.surface)];
  // What transfer does not hold.
  const SurfaceLighting straight{.lights = film.lighting.lights};
  PointRadiance sent;
  const std::uint64_t pairs =
      surface_radiance(film.medium, film.visibility, shading.transferred ? straight : film.lighting,
                       shading, points, film.arithmetic, sent);
  if (shading.transferred) shading.transferred->add(own_hits, points, sent);
  for (std::size_t k = 0; k < seen.size(); ++k) {
    radiance[seen[k].pixel] = {sent.r[k], sent.g[k], sent.b[k]};
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
    std::array<Seen, Tiles::pixels> seen;
    std::size_t count = 0;
    std::size_t k = 0;
    Tiles::each_pixel(rectangle, [&](int x, int y) {
      const std::size_t i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      radiance[i] = glm::vec3(0.0f);
      if (hits[i]) {
        seen[count++] = {hits[i], {directions.x[k], directions.y[k], directions.z[k]}, i};
      }
      ++k;
    });
    for (auto first = seen.begin(), last = first + static_cast<std::ptrdiff_t>(count);
         first != last;) {
      const auto after = std::stable_partition(
          first, last,
          [surface = first->hit.surface](const Seen& s) { return s.hit.surface == surface; });
      pairs += shade_points(*this, std::span(first, after), radiance);
      first = after;
    }
  });
  return pairs;
}

}  // namespace brume
