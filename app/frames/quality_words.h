#pragma once

#include <QString>
#include <optional>

#include "render/quality/frame_errors.h"

namespace brume {

class FrameScheduler;

// What is known of how exact the shown picture is.
struct QualityState {
  bool is_measured = false;   // the picture at rest and its error, or its noise
  bool is_exhausted = false;  // `auto` has no finer setting
  double max_error = 0.0;     // that `auto` is to keep
  std::optional<FrameError> error{};
  std::optional<double> noise{};  // of a path-traced picture
};

// "settled", "refining", or what cannot be met and what to do. An error of the airlight that the
// picture does not show is none that an eye sees.
QString quality_words(const QualityState& state);
QualityState quality_state(const FrameScheduler& frames);

}  // namespace brume
