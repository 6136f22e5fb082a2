#pragma once

#include <QWidget>
#include <functional>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

class QComboBox;
class QScrollArea;

namespace brume {

class Document;
class KeyframeTrack;
class Timeline;

// The timeline: playback controls, frame slider, range, loop, keyframe target, and tracks.
class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  // `view`: camera for camera keyframes.
  TimelineBar(Timeline& timeline, Document& document, std::function<Camera()> view,
              QWidget* parent);

  // Sets a keyframe of the selected target at the current frame.
  void set_key();

 private:
  void set_playback(const Playback& playback);  // one undo step
  void refresh_targets();
  void fit_keys();  // shows a few tracks at once

  Document& document_;
  std::function<Camera()> view_;
  QComboBox* target_;
  KeyframeTrack* keys_;
  QScrollArea* key_area_;
};

}  // namespace brume
