#include "render/cpu/film_samples.h"

#include <algorithm>
#include <atomic>

#include "render/samples/pixel_filter.h"

namespace brume {
namespace {

// Pixels whose samples let expect more than this error, relative to the picture's RMS, are sampled
// anew, four times as finely each time. They are few, so frames are off by less than a tenth of it,
// but for foliage. Each is judged by itself: a ranking would depend on which are rendered.
constexpr double max_pixel_error = 0.1;
constexpr int refinements = 2;

void write(const SampledPixel& from, Frame& frame) {
  const std::size_t i = from.pixel;
  for (std::size_t c = 0; c < 3; ++c) {
    frame.beauty[4 * i + c] = finite(from.beauty[static_cast<int>(c)]);
    frame.airlight[3 * i + c] = from.airlight[static_cast<int>(c)];
    frame.transmittance[3 * i + c] = from.transmittance;
    if (frame.background.empty()) continue;
    frame.background[3 * i + c] = finite(from.background[static_cast<int>(c)]);
  }
  frame.beauty[4 * i + 3] = std::min(from.alpha, 1.0f);
}

// Leaves details only where pixels err too much. Whether there are such.
bool keep_worst(std::span<const SampledPixel> pixels, double max_variance,
                std::vector<PixelDetail>& details) {
  bool has_any = false;
  for (const SampledPixel& pixel : pixels) {
    const bool is_worst = static_cast<double>(pixel.variance) > max_variance;
    if (!is_worst) details[pixel.pixel] = PixelDetail::none;
    has_any |= is_worst;
  }
  return has_any;
}

// The pairs that samples of pixels have cost.
struct SampleCost {
  std::atomic<std::uint64_t> view_pairs = 0, light_pairs = 0;
};

// The pixels with details of tiles so far from the region.
std::vector<SampledPixel> sample_tiles(const SampledView& view,
                                       std::span<const PixelDetail> details,
                                       std::span<const glm::dvec2> offsets, int distance,
                                       const Job& job, Frame& frame, SampleCost& cost) {
  std::vector<std::vector<SampledPixel>> results(view.tiles.tiles.count());
  job.parallel_for_with_progress(results.size(), [&](std::size_t tile) {
    if (!view.tiles.is_within(distance, tile)) return;
    TileSampler sampler(view, details, offsets, job, frame);
    sampler.sample(tile, results[tile]);
    cost.view_pairs += sampler.view_pairs();
    cost.light_pairs += sampler.light_pairs();
  });
  std::vector<SampledPixel> all;
  for (const std::vector<SampledPixel>& tile : results) {
    all.insert(all.end(), tile.begin(), tile.end());
  }
  return all;
}

}  // namespace

std::uint64_t sample_film(const SampledView& view, std::vector<PixelDetail> details, int count,
                          const Job& job, Frame& frame) {
  SampleCost cost;
  // Written at the end: pixels take the fog of those beside them.
  std::vector<SampledPixel> sampled;
  const double max_error = max_pixel_error * view.picture_rms;
  for (int round = 0; round <= refinements; ++round) {
    const std::vector<glm::dvec2> offsets = pixel_samples(count << (2 * round));
    const Job part = job.subrange(round / (refinements + 1.0), (round + 1) / (refinements + 1.0));
    const std::vector<SampledPixel> results =
        sample_tiles(view, details, offsets, FilmWindow::sampled, part, frame, cost);
    sampled.insert(sampled.end(), results.begin(), results.end());
    if (round == 0) frame.statistics.sampled_pixels += sampled.size();
    // Where the small picture saw nothing, nobody knows what counts.
    if (!(max_error > 0.0)) break;
    // Sums over channels.
    if (!keep_worst(results, 3.0 * max_error * max_error, details)) break;
  }
  frame.airlight_at_centers = frame.airlight;
  frame.beauty_at_centers = frame.beauty;
  for (const SampledPixel& pixel : sampled) write(pixel, frame);
  frame.statistics.light_pairs += cost.light_pairs;
  return cost.view_pairs;
}

std::uint64_t see_through_panes(const SampledView& view, std::span<const PixelDetail> sees_panes,
                                int distance, const Job& job, Frame& frame) {
  SampleCost cost;
  const std::vector<glm::dvec2> center = pixel_samples(1);
  for (const SampledPixel& pixel :
       sample_tiles(view, sees_panes, center, distance, job, frame, cost)) {
    write(pixel, frame);
    frame.depth[pixel.pixel] = pixel.depth;
  }
  frame.statistics.light_pairs += cost.light_pairs;
  return cost.view_pairs;
}

}  // namespace brume
