#pragma once

#include <QWidget>
#include <functional>

#include "app/document/keyframe_tracks.h"
#include "brume/camera.h"
#include "brume/scene.h"

class QComboBox;
class QScrollArea;

namespace brume {

class Document;
class FrameSlider;
class KeyframeTrack;
class PictureCache;
class PlaybackLabel;
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
  // The active view shows the picture of a time [s].
  void picture_shown(double time);
  // Which frames of a view (its index) are cached.
  void show_cached(const PictureCache& cache, int view);

 Q_SIGNALS:
  void curves_asked_for();  // shown or hidden
  void refused(const QString& problem);

 private:
  void set_playback(const Playback& playback);       // one undo step
  [[nodiscard]] std::vector<Track> targets() const;  // what keyframes can be set of
  void refresh_targets();
  void fit_keys();  // shows a few tracks at once

  Timeline& timeline_;
  Document& document_;
  std::function<Camera()> view_;
  FrameSlider* slider_;
  PlaybackLabel* playback_;
  QComboBox* target_;
  std::vector<Track> rows_;  // those in it
  KeyframeTrack* keys_;
  QScrollArea* key_area_;
};

}  // namespace brume
