#include "render/frame_errors.h"

#include <algorithm>

namespace brume {
namespace {

constexpr double sample_tolerance = 1e-3;
constexpr int most_doublings = 3;

// The reference takes time per pixel that grows with the number of Gaussians, and more where light
// comes from all around; the sample shrinks with it, by count and not by clock, so that the same
// scene always gets the same settings.
std::size_t sample_pixels(const Scene& scene) {
  const std::size_t most = scene.environment ? 64 : 128;
  return std::clamp<std::size_t>(800'000 / (scene.medium.size() + 1), 40, most);
}

bool is_undecided(const ErrorEstimate& error, double max_error) {
  return error.low <= max_error && max_error < error.high;
}

}  // namespace

std::optional<ErrorEstimate> FrameErrors::measure(const Frame& frame,
                                                  std::optional<double> max_error,
                                                  const std::stop_token& stop) {
  if (!sample_) {
    sample_ = ErrorSample::take(scene_, camera_, frame, sample_pixels(scene_), seed_,
                                sample_tolerance, stop);
    if (!sample_) return std::nullopt;
  }
  ErrorEstimate error = sample_->measure(frame);
  while (max_error && is_undecided(error, *max_error) && times_grown_ < most_doublings) {
    if (!sample_->grow(stop)) return std::nullopt;
    ++times_grown_;
    error = sample_->measure(frame);
  }
  return error;
}

}  // namespace brume
