#pragma once

#include <QWidget>
#include <functional>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

class QComboBox;
class QScrollArea;

namespace brume {

class Document;
class KeyStrip;
class Timeline;

// The timeline: play, step, the frame on a slider, the range, loop; what to set a key of; and below
// it the keys.
class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  // `view` is what a key of the camera takes.
  TimelineBar(Timeline& timeline, Document& document, std::function<Camera()> view,
              QWidget* parent);

  // Sets a key of what is chosen, at the frame shown.
  void set_key();

 private:
  void set_playback(Playback playback);  // one step
  void refresh_targets();
  void fit_keys();  // a few rows are seen at once

  Document& document_;
  std::function<Camera()> view_;
  QComboBox* target_;
  KeyStrip* keys_;
  QScrollArea* key_area_;
};

}  // namespace brume
