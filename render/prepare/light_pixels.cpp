#include "render/prepare/light_pixels.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <tuple>
#include <utility>

#include "render/geometry/tiles.h"

namespace brume {
namespace {

// The first of `width` pixels in a row whose centres are nearest to a film position.
double first_pixel(double position, int width) {
  return std::floor(position - 0.5 * (width - 1));
}

// Whether `width` pixels from there on overlap [0, size).
bool on_film(double first, int width, int size) {
  return first > -width && first < size;
}

}  // namespace

std::vector<glm::ivec2> light_pixels(std::span<const PointLight> lights, const CameraRays& rays,
                                     const Film& film, int width) {
  std::vector<glm::ivec2> pixels;
  for (const PointLight& light : lights) {
    const glm::dvec3 seen = rays.project_on_whole(light.position);
    if (!(seen.z > 0.0)) continue;
    const double x = first_pixel(seen.x, width) - rays.first_pixel().x;
    const double y = first_pixel(seen.y, width) - rays.first_pixel().y;
    // Checked before conversion to integers: a light next to the eye projects very far out.
    if (!on_film(x, width, film.width) || !on_film(y, width, film.height)) continue;
    const glm::ivec2 first(x, y);
    const glm::ivec2 begin(std::max(first.x, 0), std::max(first.y, 0));
    const glm::ivec2 end(std::min(first.x + width, film.width),
                         std::min(first.y + width, film.height));
    for (int row = begin.y; row < end.y; ++row) {
      for (int column = begin.x; column < end.x; ++column) pixels.emplace_back(column, row);
    }
  }
  const auto in_order = [](const glm::ivec2& a, const glm::ivec2& b) {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
  };
  std::ranges::sort(pixels, in_order);
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

TilePixels sort_into_tiles(std::vector<glm::ivec2> pixels, const Film& samples, int scale) {
  const Tiles tiles(samples);
  // Cells lie between samples: one less per row.
  const glm::ivec2 last = glm::max(glm::ivec2(samples.width, samples.height) - 2, 0);
  const auto tile_of = [&](const glm::ivec2& pixel) {
    const glm::ivec2 cell = glm::min(pixel / scale, last);
    return cell.y / Tiles::height * tiles.columns() + cell.x / Tiles::width;
  };
  std::ranges::stable_sort(pixels, {}, tile_of);
  TilePixels sorted;
  sorted.offsets.assign(tiles.count() + 1, 0);
  for (const glm::ivec2& pixel : pixels) {
    ++sorted.offsets[static_cast<std::size_t>(tile_of(pixel)) + 1];
  }
  std::partial_sum(sorted.offsets.begin(), sorted.offsets.end(), sorted.offsets.begin());
  sorted.pixels = std::move(pixels);
  return sorted;
}

}  // namespace brume
