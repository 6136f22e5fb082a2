#include "render/samples/denoised_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <span>
#include <utility>

#include "render/prepare/albedo.h"
#include "render/samples/mean_frame.h"

namespace brume {
namespace {

constexpr int levels = 6;  // of details

// A picture of vectors or numbers.
template <class Value>
struct Image {
  int width = 0;
  std::vector<Value> pixels;

  [[nodiscard]] int height() const {
    return width > 0 ? static_cast<int>(pixels.size()) / width : 0;
  }
};

// The B3 spline over five pixels that are `step` apart, along both axes; what is at the border goes
// on beyond it.
template <class Value>
Image<Value> smoothed(const Image<Value>& image, int step, const Job& job) {
  constexpr std::array weights{0.0625f, 0.25f, 0.375f, 0.25f, 0.0625f};
  const int height = image.height();
  const auto along = [&](const Image<Value>& input, int step_x, int step_y) {
    Image<Value> result{image.width, std::vector<Value>(image.pixels.size(), Value(0.0f))};
    job.parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
      for (int x = 0; x < image.width; ++x) {
        Value sum(0.0f);
        for (int k = 0; k < 5; ++k) {
          const int near_x = std::clamp(x + (k - 2) * step_x, 0, image.width - 1);
          const int near_y = std::clamp(static_cast<int>(row) + (k - 2) * step_y, 0, height - 1);
          sum += weights[static_cast<std::size_t>(k)] *
                 input.pixels[static_cast<std::size_t>(near_y * image.width + near_x)];
        }
        result.pixels[row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)] =
            sum;
      }
    });
    return result;
  };
  return along(along(image, step, 0), 0, step);
}

float sum_of(const glm::vec3& v) {
  return v.x + v.y + v.z;
}

// The share of the details of a size that is kept per pixel.
std::vector<float> kept_shares(std::span<const glm::vec3> one, std::span<const glm::vec3> other,
                               int width, int step, const Job& job) {
  Image<float> power{width, std::vector<float>(one.size())};
  Image<float> noise = power;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const glm::vec3 half = 0.5f * (one[i] - other[i]);
    power.pixels[i] = sum_of(one[i] * other[i]);
    noise.pixels[i] = sum_of(half * half);
  }
  for (const int around : {step, 2 * step}) {
    power = smoothed(power, around, job);
    noise = smoothed(noise, around, job);
  }
  std::vector<float> shares(one.size(), 0.0f);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    // The product scatters by as much as the noise over the few details around.
    const float certain = power.pixels[i] - noise.pixels[i];
    if (certain > 0.0f) shares[i] = certain / (certain + noise.pixels[i]);
  }
  return shares;
}

}  // namespace

std::vector<glm::vec3> significant_difference(const SolvedAndTraced& pictures, const Job& job) {
  const std::size_t count = pictures.solved.size();
  // Light far below the picture's mean is not seen.
  constexpr double dimmest_share = 1e-3;
  // Greater differences, relative to that, would be no numbers squared.
  constexpr float max_difference = 1e9f;
  Image<float> light{pictures.width, std::vector<float>(count)};
  double mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    light.pixels[i] = sum_of(pictures.solved[i]) / 3.0f;
    mean += static_cast<double>(light.pixels[i]) / static_cast<double>(count);
  }
  std::vector<glm::vec3> result(count, glm::vec3(0.0f));
  const auto dimmest = static_cast<float>(dimmest_share * mean);
  if (!(dimmest > std::numeric_limits<float>::min())) {  // nothing to be relative to
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = 0.5f * (pictures.traced[0][i] + pictures.traced[1][i]) - pictures.solved[i];
    }
    return result;
  }
  light = smoothed(light, 1, job);
  for (float& value : light.pixels) value += dimmest;

  std::array<Image<glm::vec3>, 2> rest;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    rest[k] = {pictures.width, std::vector<glm::vec3>(count)};
    for (std::size_t i = 0; i < count; ++i) {
      rest[k].pixels[i] = glm::clamp((pictures.traced[k][i] - pictures.solved[i]) / light.pixels[i],
                                     -max_difference, max_difference);
    }
  }
  const auto keep = [&](const std::array<Image<glm::vec3>, 2>& details, int step) {
    const auto& [one, other] = details;
    const std::vector<float> shares =
        kept_shares(one.pixels, other.pixels, pictures.width, step, job);
    for (std::size_t i = 0; i < count; ++i) {
      result[i] += 0.5f * shares[i] * (one.pixels[i] + other.pixels[i]);
    }
  };
  int step = 1;
  for (int level = 0; level < levels && !job.stop.stop_requested(); ++level) {
    std::array<Image<glm::vec3>, 2> details = rest;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      rest[k] = smoothed(rest[k], step, job);
      for (std::size_t i = 0; i < count; ++i) details[k].pixels[i] -= rest[k].pixels[i];
    }
    keep(details, step);
    step *= 2;
  }
  keep(rest, step / 2);
  for (std::size_t i = 0; i < count; ++i) result[i] *= light.pixels[i];
  return result;
}

namespace {

constexpr int min_blurred_paths = 64;

// Another one than between the shares of share_of_paths().
constexpr std::uint64_t seed_between_halves = 0xD1B54A32D192ED03u;

// Sets a frame's layers to solved ones and their differences, where nothing gets negative.
void set_sum(const AirlightAndOthers& solved, std::span<const glm::vec3> to_airlight,
             std::span<const glm::vec3> to_others, std::vector<float>& airlight,
             std::vector<float>& beauty) {
  for (std::size_t i = 0; 4 * i < beauty.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      float& air = airlight[3 * i + static_cast<std::size_t>(c)];
      air = finite(std::max(solved.airlight[i][c] + to_airlight[i][c], 0.0f));
      beauty[4 * i + static_cast<std::size_t>(c)] =
          finite(air + std::max(solved.others[i][c] + to_others[i][c], 0.0f));
    }
  }
}

}  // namespace

AirlightAndOthers::AirlightAndOthers(const std::vector<float>& frame_airlight,
                                     const std::vector<float>& frame_beauty) {
  for (std::size_t i = 0; 4 * i < frame_beauty.size(); ++i) {
    const float* const air = frame_airlight.data() + 3 * i;
    const float* const all = frame_beauty.data() + 4 * i;
    airlight.emplace_back(air[0], air[1], air[2]);
    others.push_back(glm::vec3(all[0], all[1], all[2]) - airlight.back());
  }
}

Settings solved_settings(int slices) {
  Settings settings = sliced_settings({}, slices);
  settings.scattering = Scattering::multiple;
  return settings;
}

void DenoisedView::denoise(Frame& traced, const Job& job) {
  const AirlightAndOthers now(traced.airlight, traced.beauty);
  // The newer half of the paths sees twice the mean of all less the older half.
  const auto difference = [&](std::span<const glm::vec3> solved,
                              const std::vector<glm::vec3>& older, std::span<const glm::vec3> all) {
    if (older.empty()) return std::vector<glm::vec3>(all.size(), glm::vec3(0.0f));
    SolvedAndTraced pictures{traced.film.width, {solved.begin(), solved.end()}, {older, {}}};
    for (std::size_t i = 0; i < all.size(); ++i) {
      pictures.traced[1].push_back(2.0f * all[i] - older[i]);
    }
    return significant_difference(pictures, job);
  };
  set_sum(solved_, difference(solved_.airlight, last_.airlight, now.airlight),
          difference(solved_.others, last_.others, now.others), traced.airlight, traced.beauty);
  last_ = now;
}

std::optional<Frame> render_denoised(FrameRenderer& renderer, const ExposedView& view,
                                     const Settings& settings, const Job& job) {
  const Scene scene = view.scene_at(view.time);
  const Camera& camera = view.camera ? *view.camera : scene.camera;
  const bool has_blur = is_blurred(view.exposure, camera);
  Settings half = settings;
  half.samples = samples_of(view.exposure, camera, scene);
  half.paths = (has_blur ? std::max(settings.paths, min_blurred_paths) : settings.paths) / 2;
  // Compared frames have the same samples of pixels: all of them, or, of still ones, centers.
  const int samples = samples_of_paths(half);
  const bool has_all = has_blur || samples == half.samples;
  ExposedView solved_view = view;
  if (has_blur) solved_view.exposure.samples = samples;
  ExposedView traced_view = view;
  traced_view.exposure.samples = has_all ? samples : 1;

  Settings solving = solved_settings(settings.slices);
  solving.threads = settings.threads;
  std::optional<Frame> frame =
      render_exposure(renderer, solved_view, solving, job.subrange(0.0, 0.3));
  if (!frame) return std::nullopt;
  const AirlightAndOthers all(frame->airlight, frame->beauty);
  const AirlightAndOthers centers(frame->airlight_at_centers, frame->beauty_at_centers);
  const AirlightAndOthers& solved = has_all || centers.airlight.empty() ? all : centers;
  SolvedAndTraced airlight{frame->film.width, solved.airlight, {}};
  SolvedAndTraced others{frame->film.width, solved.others, {}};
  for (int k = 0; k < 2; ++k) {
    Settings tracing = half;
    if (k == 1) {
      tracing.paths = std::max(settings.paths - half.paths, half.paths);
      tracing.path_seed += seed_between_halves;
    }
    const std::optional<Frame> traced = render_exposure(
        renderer, traced_view, tracing, job.subrange(0.3 + 0.35 * k, 0.65 + 0.35 * k));
    if (!traced) return std::nullopt;
    AirlightAndOthers parts(traced->airlight, traced->beauty);
    airlight.traced[k] = std::move(parts.airlight);
    others.traced[k] = std::move(parts.others);
    add_cost(traced->statistics, frame->statistics);
  }
  frame->statistics.path_noise.reset();  // it is of the paths alone
  const std::vector<glm::vec3> to_airlight = significant_difference(airlight, job);
  const std::vector<glm::vec3> to_others = significant_difference(others, job);
  if (job.stop.stop_requested()) return std::nullopt;
  set_sum(all, to_airlight, to_others, frame->airlight, frame->beauty);
  set_sum(centers, to_airlight, to_others, frame->airlight_at_centers, frame->beauty_at_centers);
  return frame;
}

}  // namespace brume
