#include "render/quality/frame_errors.h"

#include <algorithm>
#include <utility>

#include "render/util/job.h"

namespace brume {
namespace {

constexpr double sample_tolerance = 1e-3;
constexpr int max_doublings = 3;

// The reference's time per pixel grows with the number of Gaussians, and more with an environment;
// the sample shrinks accordingly, by count and not by clock, to stay deterministic.
std::size_t sample_pixels(const Scene& scene) {
  const std::size_t max_pixels = scene.environment ? 64 : 128;
  return std::clamp<std::size_t>(800'000 / (scene.medium.size() + 1), 40, max_pixels);
}

bool is_undecided(const ErrorEstimate& error, double max_error) {
  return error.low <= max_error && max_error < error.high;
}

// Whether the interval is wide, most of all because of the noise of paths.
bool is_noisy(const ErrorEstimate& error) {
  constexpr double wide = 1.5;
  return error.noise > 0.5 && error.high > wide * error.low;
}

}  // namespace

std::optional<ErrorEstimate> FrameErrors::measure(const Frame& frame,
                                                  std::optional<double> max_error,
                                                  const std::stop_token& stop,
                                                  const std::function<void(double)>& progress) {
  // Usually one sample suffices; each doubling costs as much as all before, so it gets half of the
  // remaining progress.
  const Job job{stop, progress};
  double begin = 0.0;
  const auto next_part = [&] {
    const double end = begin + 0.5 * (1.0 - begin);
    return job.subrange(std::exchange(begin, end), end).progress;
  };
  const bool has_all_orders = frame.statistics.scattering.has_value();
  if (!sample_ || has_all_orders_ != has_all_orders) {
    has_all_orders_ = has_all_orders;
    times_grown_ = 0;
    sample_ = ErrorSample::create(scene_, camera_, frame, sample_pixels(scene_), seed_,
                                  sample_tolerance, stop, next_part());
    if (!sample_) return std::nullopt;
  }
  ErrorEstimate error = sample_->measure(frame);
  while (max_error ? is_undecided(error, *max_error) : is_noisy(error)) {
    // More paths or more pixels, whichever the interval is wide for.
    if (!is_noisy(error) || !sample_->refine(stop, next_part())) {
      if (stop.stop_requested()) return std::nullopt;
      if (!max_error || times_grown_ == max_doublings) break;
      if (!sample_->grow(stop, next_part())) return std::nullopt;
      ++times_grown_;
    }
    error = sample_->measure(frame);
  }
  return error;
}

}  // namespace brume
