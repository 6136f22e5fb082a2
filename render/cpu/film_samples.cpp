#include "render/cpu/film_samples.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <optional>

#include "core/scene/camera_rays.h"
#include "render/prepare/upsampling_limits.h"
#include "render/samples/pixel_filter.h"

namespace brume {
namespace {

// The samples of all pixels that are traced together.
constexpr std::size_t batch_samples = 2048;

// Pixels whose samples let expect more than this error, relative to the picture's RMS, are sampled
// anew, four times as finely each time. They are few, so frames are off by less than a tenth of it,
// but for foliage. Each is judged by itself: a ranking would depend on which are rendered.
constexpr double max_pixel_error = 0.1;
constexpr int refinements = 2;

struct SampledPixel {
  std::size_t pixel = 0;
  glm::vec3 beauty{0.0f}, airlight{0.0f}, background{0.0f};
  float alpha = 0.0f, transmittance = 0.0f;
  float square = 0.0f;    // mean of the samples' beauty squared, sum over channels
  float variance = 0.0f;  // of beauty, as estimated
};

// Samples of a pixel about as far away, which see through the same fog.
struct SampleCluster {
  std::size_t pixel = 0;     // of the batch
  glm::dvec2 position{0.0};  // mean, on the whole film
  double length = 0.0;       // the same
  glm::vec3 behind{0.0f};    // radiance of their surfaces or background, mean
  float square = 0.0f;       // of that, mean, sum over channels
  float share = 0.0f;        // of the pixel's samples
  float solid = 0.0f;        // of the pixel's samples, those that hit surfaces
  glm::vec3 airlight{0.0f};
  float transmittance = 1.0f;
};

// Samples the pixels of one tile after another.
class TileSampler {
 public:
  TileSampler(const SampledView& view, std::span<const PixelDetail> details,
              std::span<const glm::dvec2> offsets, const Job& job, Frame& frame)
      : view_(view),
        details_(details),
        offsets_(offsets),
        job_(job),
        frame_(frame),
        waiting_(view.surfaces ? view.surfaces->surfaces.size() : 0) {}

  void sample(std::size_t tile, std::vector<SampledPixel>& results) {
    tile_ = tile;
    tolerance_ = std::numeric_limits<float>::infinity();
    if (view_.medium) {
      tolerance_ = distance_tolerance(*view_.medium, view_.tiles.lists.gaussians_of(tile),
                                      view_.fog_tolerance);
    }
    const std::size_t most = std::max<std::size_t>(1, batch_samples / offsets_.size());
    const CameraRays::PixelRectangle r = view_.tiles.own_pixels(tile);
    for (int y = r.y0; y < r.y1; ++y) {
      for (int x = r.x0; x < r.x1; ++x) {
        if (details_[index({x, y})] == PixelDetail::none) continue;
        pixels_.emplace_back(x, y);
        if (pixels_.size() == most) finish_batch(results);
      }
    }
    finish_batch(results);
  }

  [[nodiscard]] std::uint64_t view_pairs() const { return view_pairs_; }
  [[nodiscard]] std::uint64_t light_pairs() const { return light_pairs_; }

 private:
  [[nodiscard]] std::size_t index(const glm::ivec2& pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(frame_.film.width) +
           static_cast<std::size_t>(pixel.x);
  }
  // On the whole film.
  [[nodiscard]] glm::dvec2 center(const glm::ivec2& pixel) const {
    return glm::dvec2(view_.tiles.rays.first_pixel() + pixel) + 0.5;
  }
  [[nodiscard]] glm::dvec2 position(std::size_t sample) const {
    return center(pixels_[sample / offsets_.size()]) + offsets_[sample % offsets_.size()];
  }

  void finish_batch(std::vector<SampledPixel>& results) {
    if (job_.stop.stop_requested()) pixels_.clear();
    if (pixels_.empty()) return;
    find_hits();
    find_background();
    shade_surfaces();
    clusters_.clear();
    for (std::size_t k = 0; k < pixels_.size(); ++k) make_clusters(k);
    find_fog();
    const std::size_t first = results.size();
    for (const glm::ivec2& pixel : pixels_) results.push_back({.pixel = index(pixel)});
    for (const SampleCluster& c : clusters_) {
      SampledPixel& to = results[first + c.pixel];
      to.airlight += c.share * c.airlight;
      to.transmittance += c.share * c.transmittance;
      to.beauty += c.share * (c.airlight + c.transmittance * c.behind);
      if (c.solid == 0.0f) to.background += c.share * c.transmittance * c.behind;
      to.alpha += c.solid + (c.share - c.solid) * (1.0f - c.transmittance);
      to.square += c.share * (glm::dot(c.airlight, c.airlight + 2.0f * c.transmittance * c.behind) +
                              c.transmittance * c.transmittance * c.square);
    }
    // The variance of an edge in a stratified set of n samples falls with n^1.5.
    const auto n = static_cast<float>(offsets_.size());
    for (SampledPixel& pixel : std::span(results).subspan(first)) {
      // It is unknown for radiances whose squares no float holds, and taken for none.
      const float spread = pixel.square - glm::dot(pixel.beauty, pixel.beauty);
      pixel.variance = std::isfinite(spread) ? std::max(spread, 0.0f) / (n * std::sqrt(n)) : 0.0f;
    }
    pixels_.clear();
  }

  void find_hits() {
    const std::size_t count = pixels_.size() * offsets_.size();
    directions_.resize(count);
    ray_offsets_.resize(view_.tiles.rays.is_parallel() ? count : 0);
    hits_.assign(count, {});
    behind_.assign(count, glm::vec3(0.0f));
    for (std::size_t i = 0; i < count; ++i) {
      directions_[i] = view_.tiles.rays.whole_direction(position(i));
      if (!ray_offsets_.empty()) ray_offsets_[i] = view_.tiles.rays.whole_offset(position(i));
    }
    if (!view_.surfaces) return;
    for (std::size_t i = 0; i < count; i += Tiles::pixels) {
      const std::size_t some = std::min<std::size_t>(Tiles::pixels, count - i);
      const glm::dvec3& eye = view_.tiles.rays.eye();
      const std::span<const glm::dvec3> directions = std::span(directions_).subspan(i, some);
      std::span<const glm::dvec3> offsets = ray_offsets_;
      if (!offsets.empty()) offsets = offsets.subspan(i, some);
      const std::span<SurfaceHit> hits = std::span(hits_).subspan(i, some);
      view_.surfaces->ray_caster.first_hits(eye, directions, offsets, hits);
      view_.surfaces->light_shapes.meet(eye, directions, offsets, hits);
    }
  }

  void find_background() {
    if (!view_.environment) return;
    constexpr std::array open{std::numeric_limits<float>::infinity()};
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      if (hits_[i]) continue;
      view_.environment->show(directions_[i], glm::dvec3(0.0), 0, open,
                              std::span(behind_).subspan(i, 1));
    }
  }

  void shade_surfaces() {
    if (!view_.are_lit) return;
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      if (!hits_[i]) continue;
      if (hits_[i].is_light()) {
        behind_[i] = view_.surfaces->light_shapes.of(hits_[i]).radiance;
        continue;
      }
      std::vector<std::size_t>& samples = waiting_[static_cast<std::size_t>(hits_[i].surface)];
      samples.push_back(i);
      if (samples.size() == Tiles::pixels) shade(samples);
    }
    for (std::vector<std::size_t>& samples : waiting_) shade(samples);
  }

  // Samples that see one surface.
  void shade(std::vector<std::size_t>& samples) {
    if (samples.empty()) return;
    std::array<SurfaceHit, Tiles::pixels> hits;
    std::array<glm::vec3, Tiles::pixels> directions, radiance;
    std::array<glm::dvec3, Tiles::pixels> offsets;
    std::array<glm::ivec2, Tiles::pixels> seen_in;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      hits[k] = hits_[samples[k]];
      seen_in[k] = pixels_[samples[k] / offsets_.size()];
      directions[k] = glm::vec3(directions_[samples[k]]);
      if (!ray_offsets_.empty()) offsets[k] = ray_offsets_[samples[k]];
    }
    light_pairs_ += view_.surfaces->shade(
        std::span(hits).first(samples.size()), std::span(directions).first(samples.size()),
        std::span(offsets).first(ray_offsets_.empty() ? 0 : samples.size()),
        std::span(seen_in).first(samples.size()), *view_.highlights,
        std::span(radiance).first(samples.size()));
    for (std::size_t k = 0; k < samples.size(); ++k) behind_[samples[k]] = radiance[k];
    samples.clear();
  }

  // Whether a distance goes on from those of a cluster: as a surface does, so little that the fog
  // of their mean is the mean of their fog.
  [[nodiscard]] bool continues(double nearest, double before, double distance) const {
    constexpr double max_relative_span = 0.2;
    return distance - nearest <= std::max<double>(tolerance_, max_relative_span * nearest) &&
           distance - before <= std::max<double>(tolerance_, max_relative_step * before);
  }

  void make_clusters(std::size_t k) {
    const std::size_t first = k * offsets_.size();
    order_.resize(offsets_.size());
    std::iota(order_.begin(), order_.end(), first);
    const auto distance = [&](std::size_t sample) { return hits_[sample].distance; };
    std::ranges::sort(order_, {}, distance);
    const bool is_apart = view_.medium && details_[index(pixels_[k])] == PixelDetail::fog;
    const float weight = 1.0f / static_cast<float>(offsets_.size());
    double nearest = 0.0, before = 0.0;
    for (const std::size_t sample : order_) {
      const bool is_open = !hits_[sample];
      const double length = distance(sample);
      if (clusters_.empty() || clusters_.back().pixel != k || is_apart ||
          (is_open ? std::isfinite(before) : !continues(nearest, before, length))) {
        clusters_.push_back({.pixel = k});
        nearest = length;
      }
      before = length;
      // Sums for now.
      SampleCluster& c = clusters_.back();
      c.position += position(sample);
      c.length += is_open ? view_.tiles.ends.open : distance(sample);
      c.behind += behind_[sample];
      c.square += glm::dot(behind_[sample], behind_[sample]);
      c.share += weight;
      if (!is_open) c.solid += weight;
    }
    for (std::size_t i = clusters_.size(); i-- > 0 && clusters_[i].pixel == k;) {
      SampleCluster& c = clusters_[i];
      const auto count = static_cast<double>(std::round(c.share / weight));
      c.position /= count;
      c.length /= count;
      c.behind /= static_cast<float>(count);
      c.square /= static_cast<float>(count);
    }
  }

  // Airlight and transmittance of all clusters.
  void find_fog() {
    if (!view_.medium) return;
    exact_.clear();
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      SampleCluster& c = clusters_[i];
      const bool has_details = details_[index(pixels_[c.pixel])] == PixelDetail::fog;
      const std::optional<std::size_t> pixel =
          has_details ? std::nullopt : similar_pixel(pixels_[c.pixel], c);
      if (!pixel) {
        exact_.push_back(i);
        if (exact_.size() == Tiles::pixels) evaluate_fog();
        continue;
      }
      c.airlight = {frame_.airlight[3 * *pixel], frame_.airlight[3 * *pixel + 1],
                    frame_.airlight[3 * *pixel + 2]};
      c.transmittance = frame_.transmittance[3 * *pixel];
    }
    evaluate_fog();
  }

  // The pixel nearest to a cluster, among those around `middle`, that is about as far away.
  [[nodiscard]] std::optional<std::size_t> similar_pixel(const glm::ivec2& middle,
                                                         const SampleCluster& c) const {
    std::optional<std::size_t> found;
    double nearest = std::numeric_limits<double>::infinity();
    for (int y = std::max(middle.y - 1, 0); y < std::min(middle.y + 2, frame_.film.height); ++y) {
      for (int x = std::max(middle.x - 1, 0); x < std::min(middle.x + 2, frame_.film.width); ++x) {
        const std::size_t pixel = index({x, y});
        const bool is_open = !std::isfinite(frame_.depth[pixel]);
        if (is_open != (c.solid == 0.0f)) continue;
        if (!is_open &&
            std::abs(view_.tiles.ends.distance(frame_, pixel) - c.length) > tolerance_) {
          continue;
        }
        const double distance = glm::distance(center({x, y}), c.position);
        if (distance < nearest) {
          nearest = distance;
          found = pixel;
        }
      }
    }
    return found;
  }

  void evaluate_fog() {
    if (exact_.empty()) return;
    std::array<glm::dvec3, Tiles::pixels> directions, offsets;
    std::array<double, Tiles::pixels> lengths, depths;
    std::array<glm::vec2, Tiles::pixels> places;
    std::array<glm::vec3, Tiles::pixels> airlight;
    const std::size_t count = exact_.size();
    for (std::size_t k = 0; k < count; ++k) {
      const SampleCluster& c = clusters_[exact_[k]];
      directions[k] = view_.tiles.rays.whole_direction(c.position);
      offsets[k] = view_.tiles.rays.whole_offset(c.position);
      lengths[k] = c.length;
      places[k] = view_.tiles.place(tile_, c.position);
    }
    const std::uint64_t pairs = view_.method->evaluate(
        view_.tiles.lists.gaussians_of(tile_),
        {view_.tiles.rays.eye(), std::span(directions).first(count),
         std::span(lengths).first(count), tile_, std::span(places).first(count),
         std::span(offsets).first(view_.tiles.rays.is_parallel() ? count : 0)},
        {std::span(airlight).first(count), std::span(depths).first(count)});
    const float each = static_cast<float>(pairs) / static_cast<float>(count);
    for (std::size_t k = 0; k < count; ++k) {
      SampleCluster& c = clusters_[exact_[k]];
      c.airlight = {finite(airlight[k].x), finite(airlight[k].y), finite(airlight[k].z)};
      c.transmittance = finite(static_cast<float>(std::exp(-depths[k])));
      frame_.statistics.pixel_pairs[index(pixels_[c.pixel])] += each;
    }
    view_pairs_ += pairs;
    exact_.clear();
  }

  const SampledView& view_;
  std::span<const PixelDetail> details_;
  std::span<const glm::dvec2> offsets_;
  const Job& job_;
  Frame& frame_;
  std::size_t tile_ = 0;
  float tolerance_ = 0.0f;  // of distances through the same fog [u]
  std::uint64_t view_pairs_ = 0, light_pairs_ = 0;
  // The batch: pixels, and so many samples of each.
  std::vector<glm::ivec2> pixels_;
  std::vector<glm::dvec3> directions_;
  std::vector<glm::dvec3> ray_offsets_;  // of parallel rays
  std::vector<SurfaceHit> hits_;
  std::vector<glm::vec3> behind_;
  std::vector<std::vector<std::size_t>> waiting_;  // samples to shade, per surface
  std::vector<std::size_t> order_;
  std::vector<SampleCluster> clusters_;
  std::vector<std::size_t> exact_;  // clusters whose fog is evaluated
};

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

}  // namespace

std::uint64_t sample_film(const SampledView& view, std::vector<PixelDetail> details, int count,
                          const Job& job, Frame& frame) {
  std::atomic<std::uint64_t> view_pairs = 0, light_pairs = 0;
  // Written at the end: pixels take the fog of those beside them.
  std::vector<SampledPixel> sampled;
  const double max_error = max_pixel_error * view.picture_rms;
  for (int round = 0; round <= refinements; ++round) {
    const std::vector<glm::dvec2> offsets = pixel_samples(count << (2 * round));
    const Job part = job.subrange(round / (refinements + 1.0), (round + 1) / (refinements + 1.0));
    std::vector<std::vector<SampledPixel>> results(view.tiles.tiles.count());
    part.parallel_for_with_progress(results.size(), [&](std::size_t tile) {
      if (!view.tiles.is_within(FilmWindow::sampled, tile)) return;
      TileSampler sampler(view, details, offsets, part, frame);
      sampler.sample(tile, results[tile]);
      view_pairs += sampler.view_pairs();
      light_pairs += sampler.light_pairs();
    });
    const std::size_t first = sampled.size();
    for (const std::vector<SampledPixel>& tile : results) {
      sampled.insert(sampled.end(), tile.begin(), tile.end());
    }
    if (round == 0) frame.statistics.sampled_pixels += sampled.size();
    // Where the small picture saw nothing, nobody knows what counts.
    if (!(max_error > 0.0)) break;
    // Sums over channels.
    if (!keep_worst(std::span(sampled).subspan(first), 3.0 * max_error * max_error, details)) break;
  }
  frame.airlight_at_centers = frame.airlight;
  frame.beauty_at_centers = frame.beauty;
  for (const SampledPixel& pixel : sampled) write(pixel, frame);
  frame.statistics.light_pairs += light_pairs;
  return view_pairs;
}

}  // namespace brume
