#pragma once

#include <QWidget>
#include <vector>

#include "app/document/keyframe_tracks.h"

class QComboBox;

namespace brume {

class CurveEditor;
class Document;
class Timeline;

// A curve editor with the choice of its track.
class CurvePanel : public QWidget {
  Q_OBJECT
 public:
  CurvePanel(Timeline& timeline, Document& document, QWidget* parent);

  // Shows the curves of a value; nothing if it has no keyframes.
  void show_track(const Track& track);

 private:
  void refresh();
  void show_chosen();

  Document& document_;
  QComboBox* track_;
  CurveEditor* editor_;
  std::vector<Track> rows_;
};

}  // namespace brume
