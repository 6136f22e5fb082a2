#include "app/panels/time/playback_label.h"

#include <algorithm>
#include <cmath>

#include "app/document/text/number_text.h"
#include "app/document/time/timeline.h"

namespace brume {

QString playback_text(double measured, double of_scene) {
  const double dropped = std::round(std::max(0.0, of_scene - measured));
  const QString rate = PlaybackLabel::tr("%1 of %2 fps")
                           .arg(number_text(std::min(std::round(measured), std::round(of_scene))),
                                number_text(of_scene, 5));
  return dropped == 0.0 ? rate : PlaybackLabel::tr("%1, %2 dropped").arg(rate).arg(dropped);
}

PlaybackLabel::PlaybackLabel(const Timeline& timeline, QWidget* parent)
    : PlainLabel(parent), timeline_(timeline) {
  setToolTip(
      tr("Frames per second that the view shows, of the scene's rate. Frames that take too long "
         "are dropped, so that time runs as it will; once a loop is cached, none are."));
  // Its neighbours keep their places while the numbers come, change and go.
  constexpr int margin = 8;  // pixels
  setContentsMargins(margin, 0, margin, 0);
  setMinimumWidth(fontMetrics().horizontalAdvance(playback_text(2.0, 29.97)) + 2 * margin);
  clock_.start();
  constexpr int interval = 250;  // milliseconds: can be read
  timer_.setInterval(interval);
  connect(&timer_, &QTimer::timeout, this, &PlaybackLabel::show_rate);
  connect(&timeline_, &Timeline::changed, this, &PlaybackLabel::follow);
}

void PlaybackLabel::picture_shown(double time) {
  if (timer_.isActive()) {
    rate_.show(static_cast<int>(std::round(timeline_.frame_of(time))), clock_.elapsed());
  }
}

void PlaybackLabel::follow() {
  const bool plays = timeline_.is_playing();
  if (plays == timer_.isActive()) return;
  if (plays) {
    rate_.start(clock_.elapsed());
    timer_.start();
  } else {
    timer_.stop();
  }
  setText({});
}

void PlaybackLabel::show_rate() {
  const std::int64_t now = clock_.elapsed();
  const double measured = rate_.measured(now);
  if (measured > 0.0) setText(playback_text(measured, timeline_.frames_per_second()));
}

}  // namespace brume
