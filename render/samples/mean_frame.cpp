#include "render/samples/mean_frame.h"

#include <algorithm>
#include <utility>

#include "render/paths/path_random.h"
#include "render/prepare/albedo.h"
#include "render/samples/pixel_filter.h"

namespace brume {
namespace {

// Two stratified blocks, by which their noise is known.
constexpr int min_paths = 2 * path_block;

void add(const std::vector<float>& layer, float weight, std::vector<float>& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * layer[i];
}

}  // namespace

std::optional<Frame> mean_frame(Frame center, int count, const Job& job, const RenderNth& render) {
  std::optional<Frame> mean;
  int paths = 0;
  for (int k = 0; k < count; ++k) {
    const std::optional<Frame> frame =
        render(k, job.subrange(static_cast<double>(k) / count, (k + 1.0) / count));
    if (!frame) return std::nullopt;
    if (!mean) {
      mean.emplace();
      mean->film = center.film;
      mean->camera = center.camera;
      mean->time = center.time;
      mean->frames_per_second = center.frames_per_second;
      mean->beauty.resize(frame->beauty.size());
      mean->airlight.resize(frame->airlight.size());
      mean->transmittance.resize(frame->transmittance.size());
      mean->background.resize(frame->background.size());
      mean->statistics = frame->statistics;
    } else {
      add_cost(frame->statistics, mean->statistics);
    }
    if (frame->statistics.path_noise) paths += frame->statistics.path_noise->paths;
    const float weight = 1.0f / static_cast<float>(count);
    add(frame->beauty, weight, mean->beauty);
    add(frame->airlight, weight, mean->airlight);
    add(frame->transmittance, weight, mean->transmittance);
    add(frame->background, weight, mean->background);
  }
  if (!mean) return center;
  if (auto& noise = mean->statistics.path_noise) {
    noise->paths = paths;
    noise->airlight_variance /= static_cast<double>(count) * count;
    noise->surface_variance /= static_cast<double>(count) * count;
  }
  mean->depth = std::move(center.depth);
  mean->airlight_at_centers = std::move(center.airlight);
  mean->beauty_at_centers = std::move(center.beauty);
  return mean;
}

int samples_of_paths(const Settings& settings) {
  if (settings.airlight != AirlightMethod::path) return settings.samples;
  return std::clamp(settings.paths / min_paths, 1, settings.samples);
}

Settings share_of_paths(const Settings& settings, int k, int count) {
  Settings share = settings;
  // Whole blocks, which are stratified; the last one takes the rest.
  const int blocks = settings.paths / path_block;
  const auto first = [=](int n) { return n * blocks / count * path_block; };
  share.paths = (k + 1 == count ? settings.paths : first(k + 1)) - first(k);
  share.path_seed += static_cast<std::uint64_t>(k) * 0x9E3779B97F4A7C15u;  // far from other seeds
  return share;
}

std::optional<Frame> render_shifted(const Film& film, const Settings& settings, const Job& job,
                                    const RenderFilm& render) {
  const int count = samples_of_paths(settings);
  Settings single = settings;
  single.samples = 1;
  if (count == 1) return render(film, single, job);
  const double first = 1.0 / (count + 1);
  Settings of_center = single;
  of_center.paths = 1;
  std::optional<Frame> center = render(film, of_center, job.subrange(0.0, first));
  if (!center) return std::nullopt;
  const std::vector<glm::dvec2> samples = pixel_samples(count);
  return mean_frame(std::move(*center), count, job.subrange(first, 1.0),
                    [&](int k, const Job& part) {
                      Film shifted = film;
                      shifted.shift += samples[static_cast<std::size_t>(k)];
                      return render(shifted, share_of_paths(single, k, count), part);
                    });
}

}  // namespace brume
