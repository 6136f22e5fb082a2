#include "render/cpu/film_airlight.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "render/cpu/halved_cells.h"
#include "render/cpu/upsampling.h"
#include "render/prepare/light_pixels.h"

namespace brume {
namespace {

// The pixels of a tile that one call of a method evaluates.
class Batch {
 public:
  // Adds to the pairs of the frame's pixels.
  Batch(const FilmTiles& film, std::size_t tile, Frame& frame)
      : film_(film), tile_(tile), frame_(frame) {
    const CameraRays::PixelRectangle samples = film.tiles.rectangle(tile);
    first_ = glm::vec2(samples.x0 * film.scale, samples.y0 * film.scale);
    per_pixel_ = 1.0f / glm::vec2(Tiles::width * film.scale, Tiles::height * film.scale);
  }

  // Pixels that share what a method prepares for a tile.
  static constexpr std::size_t max_pixels = 4 * Tiles::pixels;
  [[nodiscard]] bool full() const { return count_ == max_pixels; }

  void add(int x, int y) {
    pixels_[count_] = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.film.width) +
                      static_cast<std::size_t>(x);
    lengths_[count_] = film_.ends.distance(frame_.depth, pixels_[count_]);
    // The last pixels of a film may lie slightly outside the tile.
    places_[count_] = glm::min((glm::vec2(x, y) - first_) * per_pixel_, 1.0f);
    if (film_.rays.is_parallel()) offsets_[count_] = film_.rays.offset(x + 0.5, y + 0.5);
    directions_[count_++] = film_.rays.direction(x + 0.5, y + 0.5);
  }

  // Evaluates what was added, calls store(pixel index, airlight and transmittance) for each pixel
  // in order, and starts anew.
  template <class Store>
  std::uint64_t evaluate(const AirlightIntegrator& method, Store store) {
    if (count_ == 0) return 0;
    const TileRays rays{film_.rays.eye(),
                        std::span(directions_).first(count_),
                        std::span(lengths_).first(count_),
                        tile_,
                        std::span(places_).first(count_),
                        std::span(offsets_).first(film_.rays.is_parallel() ? count_ : 0)};
    const std::uint64_t pairs =
        method.evaluate(film_.lists.gaussians_of(tile_), rays,
                        {std::span(airlight_).first(count_), std::span(depths_).first(count_)});
    // A tile's rays share their Gaussians.
    const float each = static_cast<float>(pairs) / static_cast<float>(count_);
    for (std::size_t k = 0; k < count_; ++k) {
      frame_.statistics.pixel_pairs[pixels_[k]] += each;
      const glm::vec3& l = airlight_[k];
      store(pixels_[k], glm::vec4(finite(l.x), finite(l.y), finite(l.z),
                                  finite(static_cast<float>(std::exp(-depths_[k])))));
    }
    count_ = 0;
    return pairs;
  }

 private:
  const FilmTiles& film_;
  std::size_t tile_;
  Frame& frame_;
  glm::vec2 first_, per_pixel_;  // of the tile
  std::size_t count_ = 0;
  std::array<std::size_t, max_pixels> pixels_;
  std::array<glm::dvec3, max_pixels> directions_, offsets_;
  std::array<double, max_pixels> lengths_;
  std::array<glm::vec2, max_pixels> places_;
  std::array<glm::vec3, max_pixels> airlight_;
  std::array<double, max_pixels> depths_;
};

// Maximum ray length over a row of pixels.
double max_end(const RayEnds& ends, const Frame& frame, std::size_t first, std::size_t count) {
  double max_distance = 0.0;
  if (!ends.surfaces.empty()) {
    for (std::size_t i = first; i < first + count; ++i)
      max_distance = std::max(max_distance, ends.distance(frame.depth, i));
    return max_distance;
  }
  // The bits of distances, as integers, have the same order, and compilers vectorize their
  // comparison.
  constexpr auto infinite = std::bit_cast<std::int32_t>(std::numeric_limits<float>::infinity());
  std::int32_t farthest = 0;
  std::int32_t any_open = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    const auto bits = std::bit_cast<std::int32_t>(frame.depth[i]);
    const std::int32_t hit = bits < infinite ? bits : 0;
    any_open |= bits ^ hit;
    farthest = farthest < hit ? hit : farthest;
  }
  max_distance = static_cast<double>(std::bit_cast<float>(farthest));
  return any_open != 0 ? std::max(max_distance, ends.open) : max_distance;
}

}  // namespace

float distance_tolerance(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                         double tolerance) {
  double tolerance_u = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : gaussians) {
    const double radius = min_radius_of(medium.gaussians()[i]);
    tolerance_u = std::min(tolerance_u, double{radii_per_tolerance} * tolerance * radius);
  }
  const double b0 = medium.homogeneous_density();
  if (b0 > 0.0)
    tolerance_u = std::min(tolerance_u, double{free_paths_per_tolerance} * tolerance / b0);
  return static_cast<float>(tolerance_u);
}

CameraRays::PixelRectangle FilmTiles::pixels(std::size_t tile) const {
  const CameraRays::PixelRectangle samples = tiles.rectangle(tile);
  const Film& film = frame.film;
  // The last cells extend to the film's border.
  const auto end = [this](int last, int size) {
    return last * scale + 1 < size ? last * scale : size;
  };
  return {std::min(samples.x0 * scale, film.width - 1),
          std::min(samples.y0 * scale, film.height - 1), end(samples.x1, film.width),
          end(samples.y1, film.height)};
}

CameraRays::PixelRectangle FilmTiles::own_pixels(std::size_t tile) const {
  const CameraRays::PixelRectangle samples = tiles.rectangle(tile);
  const Film& film = frame.film;
  const Film sampled = sample_film(film, scale);
  // The last sample of an axis may lie beyond the film, so tiles before its own reach the border.
  const auto end = [this](int last, int samples_in_all, int size) {
    return last == samples_in_all ? size : std::min(last * scale, size);
  };
  return {std::min(samples.x0 * scale, film.width), std::min(samples.y0 * scale, film.height),
          end(samples.x1, sampled.width, film.width), end(samples.y1, sampled.height, film.height)};
}

glm::vec2 FilmTiles::place(std::size_t tile, const glm::dvec2& position) const {
  const CameraRays::PixelRectangle samples = tiles.rectangle(tile);
  const glm::ivec2 first = rays.first_pixel() + scale * glm::ivec2(samples.x0, samples.y0);
  const glm::dvec2 size(Tiles::width * scale, Tiles::height * scale);
  return glm::clamp((position - 0.5 - glm::dvec2(first)) / size, 0.0, 1.0);
}

TileCone FilmTiles::cone(std::size_t tile) const {
  CameraRays::PixelRectangle r = pixels(tile);
  r = {std::max(r.x0 - margin, 0), std::max(r.y0 - margin, 0),
       std::min(r.x1 + margin, frame.film.width), std::min(r.y1 + margin, frame.film.height)};
  std::array<glm::dvec3, 4> corners, offsets;
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec2 corner((k % 2 == 0 ? r.x0 : r.x1 - 1) + 0.5,
                            (k / 2 == 0 ? r.y0 : r.y1 - 1) + 0.5);
    corners[k] = rays.direction(corner.x, corner.y);
    offsets[k] = rays.offset(corner.x, corner.y);
  }
  TileCone cone;
  cone.eye = rays.eye();
  if (rays.is_parallel()) {
    const glm::dvec3 middle = 0.5 * (offsets[0] + offsets[3]);
    cone.eye += middle;
    cone.width = glm::length(offsets[0] - middle);
  }
  cone.center = glm::normalize(corners[0] + corners[1] + corners[2] + corners[3]);
  for (const glm::dvec3& w : corners) {
    cone.spread = std::max(cone.spread, glm::length(w - cone.center));
  }
  for (int y = r.y0; y < r.y1; ++y) {
    const std::size_t first =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.film.width) +
        static_cast<std::size_t>(r.x0);
    const auto count = static_cast<std::size_t>(r.x1 - r.x0);
    cone.max_length = std::max(cone.max_length, max_end(ends, frame, first, count));
    if (std::isinf(cone.max_length)) break;
  }
  return cone;
}

FilmAirlight film_airlight(const MediumIndex& medium, std::span<const PointLight> lights,
                           const CameraRays& rays, const FilmWindow& window,
                           const Settings& settings, std::optional<double> airlight_rms,
                           const AirlightIntegrator& method, const RayEnds& ends, const Job& job,
                           Frame& frame) {
  const int scale = settings.airlight_scale;
  AirlightSamples samples(frame, scale);
  const Tiles tiles(samples.film());
  Tiles::Lists lists = tiles.lists(medium, rays, scale);
  const FilmTiles film{tiles, lists, rays, ends, frame, window, scale};
  if (method.prepare) method.prepare(film);
  FilmAirlight result;
  result.gaussians_used = lists.used;
  std::atomic<std::uint64_t> pairs = 0;
  std::atomic<std::size_t> exact = 0;
  job.parallel_for_with_progress(tiles.count(), [&](std::size_t tile) {
    if (!film.is_within(window.evaluated(), tile)) return;
    Batch batch(film, tile, frame);
    std::array<std::size_t, Tiles::pixels> order;
    std::size_t count = 0;
    Tiles::each_pixel(tiles.rectangle(tile), [&](int column, int row) {
      order[count++] = samples.index(column, row);
      batch.add(samples.x(column), samples.y(row));
    });
    count = 0;
    pairs += batch.evaluate(method, [&](std::size_t pixel, const glm::vec4& value) {
      samples.value(order[count++]) = value;
      set_airlight(frame, pixel, value);
    });
    exact += count;
  });
  if (scale > 1 && !job.stop.stop_requested()) {
    const TilePixels near_lights =
        sort_into_tiles(light_pixels(lights, rays, frame.film, light_block), samples.film(), scale);
    samples.measure_curvatures(settings.upsampling_tolerance, airlight_rms, job);
    const auto evaluate = [&](std::size_t tile, std::vector<glm::ivec2> pixels) {
      std::ranges::sort(pixels, {}, in_blocks);
      Batch batch(film, tile, frame);
      const auto flush = [&] {
        pairs += batch.evaluate(method, [&](std::size_t pixel, const glm::vec4& value) {
          ++exact;
          set_airlight(frame, pixel, value);
        });
      };
      for (const glm::ivec2& pixel : pixels) {
        if (batch.full()) flush();
        batch.add(pixel.x, pixel.y);
      }
      flush();
    };
    std::vector<float> tolerances(tiles.count());  // of distances [u]
    std::vector<Missing> missing(tiles.count());
    HalvedCells halved(samples);
    job.parallel_for(tiles.count(), [&](std::size_t tile) {
      if (!film.is_within(window.interpolated(), tile)) return;
      tolerances[tile] =
          distance_tolerance(medium, lists.gaussians_of(tile), settings.upsampling_tolerance);
      missing[tile] = upsample(samples, tiles.rectangle(tile), tolerances[tile],
                               near_lights.pixels_of(tile), frame);
      halved.add(missing[tile]);
    });
    job.parallel_for(tiles.count(), [&](std::size_t tile) {
      if (!film.is_within(window.exact(), tile)) return;
      std::vector<glm::ivec2> pixels = halved.nodes(missing[tile].cells);
      pixels.insert(pixels.end(), missing[tile].pixels.begin(), missing[tile].pixels.end());
      evaluate(tile, std::move(pixels));
    });
    job.parallel_for(tiles.count(), [&](std::size_t tile) {
      if (!film.is_within(window.complete(), tile)) return;
      evaluate(tile, fill_halved_cells(samples, missing[tile].cells, tolerances[tile], frame));
    });
  }
  result.pairs = pairs;
  result.exact_pixels = exact;
  result.lists = std::move(lists);
  return result;
}

}  // namespace brume
