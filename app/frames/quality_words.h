#pragma once

#include <QString>
#include <optional>

#include "render/quality/frame_errors.h"

namespace brume {

class FrameScheduler;

// It says how exact the shown picture is, as far as that is known.
struct QualityState {
  bool is_measured = false;    // the picture at rest and its error, or its noise
  bool is_auto = false;        // else the method was chosen, and stays
  bool has_all_paths = false;  // a path-traced picture gets no more
  double max_error = 0.0;      // that is asked for
  std::optional<FrameError> error{};
  std::optional<double> noise{};  // of a path-traced picture
};

// Words for it: "settled", "refining", or what is not met and what to do. An error of the airlight
// that the picture does not show is none that an eye sees.
QString quality_words(const QualityState& state);
QualityState quality_state(const FrameScheduler& frames);

}  // namespace brume
