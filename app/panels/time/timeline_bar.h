#pragma once

#include <QWidget>
#include <functional>

#include "brume/camera.h"
#include "brume/scene.h"

class QBoxLayout;

namespace brume {

class Document;
class DopeSheet;
class PictureCache;
class PlaybackLabel;
class Timeline;
class TimeRuler;

// The timeline: playback controls, frame and range, and below them a ruler of frames over the
// keyframes of the scene.
class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  // `view`: camera for camera keyframes.
  TimelineBar(Timeline& timeline, Document& document, std::function<Camera()> view,
              QWidget* parent);

  // Sets a keyframe at the current frame: of the values chosen in the dope sheet, else of the place
  // of the chosen object, else of the camera, which takes the view.
  void set_key();
  // The active view shows the picture of a time [s].
  void picture_shown(double time);
  // Which frames of a view (its index) are cached.
  void show_cached(const PictureCache& cache, int view);
  [[nodiscard]] DopeSheet& sheet() const { return *sheet_; }

  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void curves_asked_for();  // shown or hidden
  void refused(const QString& problem);

 private:
  void add_playback(QBoxLayout& row);
  void add_range(QBoxLayout& row);
  void add_sheet(QBoxLayout& column);
  void set_playback(const Playback& playback);  // one undo step

  Timeline& timeline_;
  Document& document_;
  std::function<Camera()> view_;
  TimeRuler* ruler_;
  DopeSheet* sheet_;
  PlaybackLabel* playback_;
};

}  // namespace brume
