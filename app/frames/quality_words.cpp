#include "app/frames/quality_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/frames/frame_scheduler.h"
#include "app/widgets/frame_text.h"

namespace brume {

QString quality_words(const QualityState& state) {
  const auto text = [](const char* words) { return QCoreApplication::translate("Quality", words); };
  if (!state.is_measured) return text("refining");
  if (state.noise) return *state.noise <= state.max_error ? text("settled") : text("refining");
  if (!state.is_exhausted || !state.error) return text("settled");
  const FrameError& error = *state.error;
  const double seen = error.picture ? std::min(error.airlight.rel_rmse, error.picture->rel_rmse)
                                    : error.airlight.rel_rmse;
  if (seen <= state.max_error) return text("settled");
  return text("%1 cannot be met here: allow more in Performance, or see Quality > Reference")
      .arg(bound_text(state.max_error));
}

QualityState quality_state(const FrameScheduler& frames) {
  const FrameQuality& quality = frames.quality();
  QualityState state{.is_measured = frames.is_measured(),
                     .is_exhausted = quality.is_exhausted(),
                     .max_error = quality.max_error(),
                     .error = quality.error()};
  if (const RenderedFrame* frame = frames.shown()) {
    if (const auto noise = relative_noise(frame->frame)) state.noise = noise->picture;
  }
  return state;
}

}  // namespace brume
