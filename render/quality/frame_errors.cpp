#include "render/quality/frame_errors.h"

#include <algorithm>
#include <utility>

namespace brume {
namespace {

constexpr double sample_tolerance = 1e-3;

// A sample becomes at most so much larger, and it and its paths at most so much together: 8 times
// the pixels, or 128 times the paths, or anything between.
constexpr int max_growths = 3;
constexpr int max_doublings = 7;
// A limit where no bound is asked for, and for the picture, which finer settings do not better.
constexpr int max_free_refinements = 4;

// The reference's time per pixel grows with the number of Gaussians, and more with an environment;
// the sample shrinks accordingly, by count and not by clock, to stay deterministic.
std::size_t sample_pixels(const Scene& scene) {
  const std::size_t max_pixels = scene.environment ? 64 : 128;
  return std::clamp<std::size_t>(800'000 / (scene.medium.size() + 1), 40, max_pixels);
}

// The first sample of a measurement that may not cost more than so much, and its paths.
// Intervals of fewer pixels seldom hold errors of single pixels.
constexpr std::size_t min_quick_pixels = 40;
constexpr std::size_t max_noisy_pixels = 64;
constexpr int quick_paths = 16;

bool is_undecided(const ErrorEstimate& error, double max_error) {
  return error.low <= max_error && max_error < error.high;
}

// Looked at again and again as a sample grows, an interval is beside the error now and then: there
// must be some room between it and the bound. Small samples may miss the few pixels that an error
// is made of.
bool is_surely_decided(const ErrorEstimate& error, double max_error) {
  constexpr std::size_t many_pixels = 256;
  constexpr double room = 1.15;
  constexpr double room_of_few = 3.0;
  const double below = error.pixels < many_pixels ? room_of_few : room;
  return below * error.high <= max_error || error.low > room * max_error;
}

// Whether a condition holds for the airlight, or for the picture where it counts.
template <class Condition>
bool any_of(const FrameError& error, bool has_picture, Condition condition) {
  return condition(error.airlight) || (has_picture && error.picture && condition(*error.picture));
}

bool is_wide(const ErrorEstimate& error) {
  constexpr double wide = 1.5;
  return error.high > wide * error.low;
}

// Whether the interval is wide, most of all because of the noise of paths.
bool is_noisy(const ErrorEstimate& error) {
  return error.noise > 0.5 && is_wide(error);
}

}  // namespace

void FrameErrors::make_reference(const Frame& frame) {
  const bool has_all_orders = frame.statistics.scattering.has_value();
  if (reference_ && has_all_orders_ == has_all_orders) return;
  has_all_orders_ = has_all_orders;
  times_grown_ = 0;
  times_refined_ = 0;
  sample_.reset();
  // A frame without more than one scattering, whatever the reason, claims to need none.
  reference_ = std::make_shared<ViewReference>(
      scene_, camera_, frame.film, sample_tolerance,
      has_all_orders ? Scattering::multiple : Scattering::single, measured_);
}

bool FrameErrors::make_sample(const Frame& frame, std::size_t pixels, int paths, const Job& job) {
  if (sample_) return true;
  sample_ = ErrorSample::create(reference_, scene_, camera_, frame, pixels, seed_, job.stop,
                                job.progress, paths);
  return sample_.has_value();
}

FrameError FrameErrors::error_of(const Frame& frame) const {
  FrameError error{sample_->measure(frame), std::nullopt};
  if (reference_->has_picture()) error.picture = sample_->measure_picture(frame);
  return error;
}

std::optional<FrameError> FrameErrors::measure(const Frame& frame, std::optional<double> max_error,
                                               const std::stop_token& stop,
                                               const std::function<void(double)>& progress) {
  // Usually one sample suffices; each doubling costs as much as all before, so it gets half of the
  // remaining progress.
  const Job job{stop, progress};
  double begin_of_part = 0.0;
  const auto next_part = [&] {
    const double end = begin_of_part + 0.5 * (1.0 - begin_of_part);
    return job.subrange(std::exchange(begin_of_part, end), end);
  };
  make_reference(frame);
  if (!make_sample(frame, sample_pixels(scene_), ErrorSample::default_paths, next_part())) {
    return std::nullopt;
  }
  const auto is_unsure = [&](const ErrorEstimate& estimate) {
    return max_error ? is_undecided(estimate, *max_error) : is_noisy(estimate);
  };
  FrameError error = error_of(frame);
  const auto has_picture = [&] { return times_grown_ + times_refined_ < max_free_refinements; };
  while (any_of(error, has_picture(), is_unsure)) {
    if (times_grown_ + times_refined_ == max_doublings) break;
    // More paths or more pixels, whichever the interval is wide for.
    const bool may_refine = max_error || times_refined_ < max_free_refinements;
    const bool is_noise = any_of(error, has_picture(), [&](const ErrorEstimate& estimate) {
      return is_unsure(estimate) && is_noisy(estimate);
    });
    if (is_noise && may_refine && sample_->refine(stop, next_part().progress)) {
      ++times_refined_;
    } else {
      if (stop.stop_requested()) return std::nullopt;
      // More paths are all that a picture gets.
      if (!max_error || times_grown_ == max_growths || !is_unsure(error.airlight)) break;
      if (!sample_->grow(stop, next_part().progress)) return std::nullopt;
      ++times_grown_;
    }
    error = error_of(frame);
  }
  return error;
}

std::optional<FrameError> FrameErrors::measure_within(double max_work, const Frame& frame,
                                                      std::optional<double> max_error,
                                                      const std::stop_token& stop,
                                                      const std::function<void(double)>& progress) {
  const Job job{stop, progress};
  make_reference(frame);
  // Integrals cost the same wherever they are; half of the work is for the first.
  const std::size_t most = std::min(
      sample_pixels(scene_), reference_->has_noisy_airlight() ? max_noisy_pixels : ~std::size_t{0});
  const double affordable = 0.5 * max_work / std::max(reference_->integral_work(), 1.0);
  const std::size_t pixels =
      affordable < static_cast<double>(most)
          ? std::max({static_cast<std::size_t>(affordable), most / 2, min_quick_pixels})
          : most;
  if (!make_sample(frame, pixels, quick_paths, job.subrange(0.0, 0.1))) return std::nullopt;
  const auto is_unsure = [&](const ErrorEstimate& estimate) {
    return max_error ? !is_surely_decided(estimate, *max_error) : is_wide(estimate);
  };
  FrameError error = error_of(frame);
  while (any_of(error, true, is_unsure)) {
    // In steps, since the first paths tell little of what is needed.
    constexpr double max_factor = 4.0;
    constexpr double min_factor = 1.25;
    const ViewReference::Work before = reference_->work();
    const double left = max_work - before.sum();
    const double refined = std::min(1.0 + left / before.paths, max_factor);
    const double grown = std::min(1.0 + left / before.sum(), max_factor);
    const Job part = job.subrange(std::min(0.1 + 0.9 * before.sum() / max_work, 1.0), 1.0);
    const bool is_noise = any_of(error, true, [&](const ErrorEstimate& estimate) {
      const bool is_above_bound = !max_error || estimate.high > *max_error;
      return is_unsure(estimate) && is_above_bound && estimate.noise > 0.5;
    });
    const bool refines = is_noise && refined >= min_factor;
    if (!(refines && sample_->refine(stop, part.progress, refined)) && grown >= min_factor) {
      static_cast<void>(sample_->grow(stop, part.progress, grown));
    }
    if (stop.stop_requested()) return std::nullopt;
    if (reference_->work().sum() == before.sum()) break;
    error = error_of(frame);
  }
  return error;
}

}  // namespace brume
