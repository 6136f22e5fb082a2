#pragma once

#include "render/quality/error_estimate.h"
#include "render/quality/view_reference.h"
#include "render/util/job.h"

namespace brume {

// How far a frame is from the truth. The airlight is compared with light of the orders of
// scattering that the frame was rendered with, the picture with all the light that there is.
struct FrameError {
  ErrorEstimate airlight;
  std::optional<ErrorEstimate> picture;  // none: only the airlight was measured
};

// Estimates the errors of frames of one view on the same pixels, so that reference pixels are
// evaluated once. The number of pixels depends on the scene, to take a few seconds at most. Not
// thread-safe.
class FrameErrors {
 public:
  // Keeps a reference to the scene. Deterministic for a given seed.
  FrameErrors(const Scene& scene, const Camera& camera, std::uint64_t seed,
              Measured measured = Measured::airlight)
      : scene_(scene), camera_(camera), seed_(seed), measured_(measured) {}

  // The error of a frame, as sure as it needs to be. All frames share film and time; the first one
  // guides the sampling. With `max_error` the sample grows, up to eightfold, while a confidence
  // interval contains the bound: pixels are cheaper than finer settings. nullopt if `stop` was
  // requested. `progress`: see FrameRenderer.
  std::optional<FrameError> measure(const Frame& frame, std::optional<double> max_error,
                                    const std::stop_token& stop = {},
                                    const std::function<void(double)>& progress = {});

  // The same for at most so much work (see work.h), but for a first sample: then the interval may
  // be wider.
  std::optional<FrameError> measure_within(double max_work, const Frame& frame,
                                           std::optional<double> max_error,
                                           const std::stop_token& stop = {},
                                           const std::function<void(double)>& progress = {});

  // What measuring has cost.
  [[nodiscard]] double work() const { return reference_ ? reference_->work().sum() : 0.0; }

 private:
  // Makes the reference, unless there is one of such frames.
  void make_reference(const Frame& frame);
  // Makes the sample, unless there is one. False if stopped.
  bool make_sample(const Frame& frame, std::size_t pixels, int paths, const Job& job);
  // The error of all that is measured, by the sample as it is.
  [[nodiscard]] FrameError error_of(const Frame& frame) const;

  const Scene& scene_;
  Camera camera_;
  std::uint64_t seed_;
  Measured measured_;
  std::optional<ErrorSample> sample_;
  std::shared_ptr<ViewReference> reference_;
  bool has_all_orders_ = false;  // of scattering, in the frames that it is for
  int times_grown_ = 0;
  int times_refined_ = 0;
};

}  // namespace brume
