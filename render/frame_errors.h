#pragma once

#include "render/error_estimate.h"

namespace brume {

// Measures the errors of frames of one view, all on the same pixels, so that what the reference
// takes is taken once. How many pixels depends on the scene, so that it takes seconds at most. For
// one thread at a time.
class FrameErrors {
 public:
  // Refers to the scene. The same for the same seed.
  FrameErrors(const Scene& scene, const Camera& camera, std::uint64_t seed)
      : scene_(scene), camera_(camera), seed_(seed) {}

  // The error of a frame; all have the same film and show the same time, and the first one guides
  // to the pixels. With `max_error` the sample grows, up to eight times as large, as long as the
  // interval does not tell whether the frame keeps it: pixels are cheaper than finer settings, and
  // must not be what makes those look needed. nullopt if `stop` was requested. `progress` as of
  // FrameRenderer.
  std::optional<ErrorEstimate> measure(const Frame& frame, std::optional<double> max_error,
                                       const std::stop_token& stop = {},
                                       const std::function<void(double)>& progress = {});

 private:
  const Scene& scene_;
  Camera camera_;
  std::uint64_t seed_;
  std::optional<ErrorSample> sample_;
  int times_grown_ = 0;
};

}  // namespace brume
