#include "app/frames/quality_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/frames/frame_scheduler.h"
#include "app/widgets/frame_text.h"

namespace brume {
namespace {

double seen_error(const FrameError& error) {
  return error.picture ? std::min(error.airlight.rel_rmse, error.picture->rel_rmse)
                       : error.airlight.rel_rmse;
}

}  // namespace

QString quality_words(const QualityState& state) {
  const auto text = [](const char* words) { return QCoreApplication::translate("Quality", words); };
  if (!state.is_measured) return text("refining");
  const QString bound = bound_text(state.max_error);
  if (state.noise) {
    if (*state.noise <= state.max_error) return text("settled");
    if (!state.has_all_paths) return text("refining");
    return text("noise above %1 with all paths of a view: a rendered frame can have more")
        .arg(bound);
  }
  if (!state.error || seen_error(*state.error) <= state.max_error) return text("settled");
  if (!state.is_auto) {
    return text("error above %1: see Quality > Auto, or Quality > Reference").arg(bound);
  }
  return text("%1 cannot be met here: allow more in Performance, or see Quality > Reference")
      .arg(bound);
}

QualityState quality_state(const FrameScheduler& frames) {
  const FrameQuality& quality = frames.quality();
  QualityState state{.is_measured = frames.is_measured(),
                     .is_auto = quality.is_auto(),
                     .has_all_paths = frames.has_all_paths(),
                     .max_error = quality.max_error()};
  if (frames.mode() != ViewMode::path_traced) state.error = quality.error();
  if (const RenderedFrame* frame = frames.shown()) {
    if (const auto noise = relative_noise(frame->frame)) state.noise = noise->picture;
  }
  return state;
}

}  // namespace brume
