#include "render/film_airlight.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "render/tiles.h"
#include "render/upsampling.h"

namespace brume {
namespace {

// The pixels of a frame that one call of a method evaluates.
class Batch {
 public:
  // Adds to the pairs of the frame's pixels.
  Batch(const CameraRays& rays, const RayEnds& ends, Frame& frame)
      : rays_(rays), ends_(ends), frame_(frame) {}

  [[nodiscard]] bool full() const { return count_ == Tiles::pixels; }

  void add(int x, int y) {
    pixels_[count_] = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.film.width) +
                      static_cast<std::size_t>(x);
    lengths_[count_] = ends_.of(frame_, pixels_[count_]);
    directions_[count_++] = rays_.direction(x + 0.5, y + 0.5);
  }

  // Evaluates what was added, calls store(pixel index, airlight and transmittance) for each pixel
  // in order, and starts anew.
  template <class Store>
  std::uint64_t evaluate(std::span<const std::uint32_t> gaussians, const TileMethod& method,
                         Store store) {
    if (count_ == 0) return 0;
    const TileRays rays{rays_.eye(), std::span(directions_).first(count_),
                        std::span(lengths_).first(count_)};
    const std::uint64_t pairs = method(
        gaussians, rays, {std::span(airlight_).first(count_), std::span(depths_).first(count_)});
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
  const CameraRays& rays_;
  const RayEnds& ends_;
  Frame& frame_;
  std::size_t count_ = 0;
  std::array<std::size_t, Tiles::pixels> pixels_;
  std::array<glm::dvec3, Tiles::pixels> directions_;
  std::array<double, Tiles::pixels> lengths_;
  std::array<glm::vec3, Tiles::pixels> airlight_;
  std::array<double, Tiles::pixels> depths_;
};

// How much nearer or farther a surface may be than expected without the airlight telling: small
// against the Gaussians of the tile and the fog's mean free path.
float depth_tolerance(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                      double tolerance) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : gaussians) {
    least = std::min(least, double{radii_per_tolerance} * tolerance / medium.gaussians()[i].a);
  }
  const double b0 = medium.homogeneous_density();
  if (b0 > 0.0) least = std::min(least, double{free_paths_per_tolerance} * tolerance / b0);
  return static_cast<float>(least);
}

}  // namespace

FilmAirlight film_airlight(const MediumIndex& medium, const CameraRays& rays,
                           const Settings& settings, const TileMethod& method, const RayEnds& ends,
                           const Job& job, Frame& frame) {
  const int scale = settings.airlight_scale;
  AirlightSamples samples(frame, scale);
  const Tiles tiles(samples.film());
  const Tiles::Lists lists = tiles.lists(medium, rays, scale);
  FilmAirlight result;
  result.gaussians_used = lists.used;
  std::atomic<std::uint64_t> pairs = 0;
  std::atomic<std::size_t> exact = 0;
  job.each_reported(tiles.count(), [&](std::size_t tile) {
    Batch batch(rays, ends, frame);
    std::array<std::size_t, Tiles::pixels> order;
    std::size_t count = 0;
    Tiles::each_pixel(tiles.rectangle(tile), [&](int column, int row) {
      order[count++] = samples.index(column, row);
      batch.add(samples.x(column), samples.y(row));
    });
    count = 0;
    pairs += batch.evaluate(lists.of(tile), method, [&](std::size_t pixel, const glm::vec4& value) {
      samples.value(order[count++]) = value;
      set_airlight(frame, pixel, value);
    });
    exact += count;
  });
  if (scale > 1 && !job.stop.stop_requested()) {
    samples.measure_bends(settings.upsampling_tolerance, job);
    job.each(tiles.count(), [&](std::size_t tile) {
      Batch batch(rays, ends, frame);
      const auto evaluate = [&] {
        pairs +=
            batch.evaluate(lists.of(tile), method, [&](std::size_t pixel, const glm::vec4& value) {
              ++exact;
              set_airlight(frame, pixel, value);
            });
      };
      const float tolerance =
          depth_tolerance(medium, lists.of(tile), settings.upsampling_tolerance);
      upsample(samples, tiles.rectangle(tile), tolerance, frame, [&](int x, int y) {
        if (batch.full()) evaluate();
        batch.add(x, y);
      });
      evaluate();
    });
  }
  result.pairs = pairs;
  result.exact_pixels = exact;
  return result;
}

}  // namespace brume
