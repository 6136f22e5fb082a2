#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "app/document/time/playback_rate.h"
#include "app/widgets/plain_text.h"

namespace brume {

class Timeline;

// How many of the frames of a second playback shows, and how many it drops: "12 of 30 fps, 18
// dropped". Empty unless it plays: its room is kept.
class PlaybackLabel : public PlainLabel {
  Q_OBJECT
 public:
  PlaybackLabel(const Timeline& timeline, QWidget* parent);

  // A view shows the picture of a time [s].
  void picture_shown(double time);

 private:
  void follow();
  void show_rate();

  const Timeline& timeline_;
  PlaybackRate rate_;
  QElapsedTimer clock_;
  QTimer timer_;  // runs during playback
};

// The text of a measured rate, of a scene's [frames/s].
QString playback_text(double measured, double of_scene);

}  // namespace brume
