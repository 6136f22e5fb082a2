#pragma once

#include <QPolygonF>
#include <QString>
#include <functional>
#include <vector>

#include "app/document/time/keyframe_tracks.h"

class QWidget;

namespace brume {

class Document;
class Timeline;

struct KeyAction {
  QString text;
  std::function<void()> run;
};

// Shows the menu of some keys: interpolation, tangents, and further actions. It says the state of
// the key of a track at a time.
void show_key_menu(QWidget& owner, Document& document, const std::vector<TrackKeys>& keys,
                   const Track& track, double time, const std::vector<KeyAction>& actions,
                   const QPoint& global_position);

// Says how far keys are moved, so that one of a time is on a frame again [s]: a key between two
// frames stays there until it is moved by one. No key gets before the start of time, or further
// before it.
double snapped_shift(const Timeline& timeline, double grabbed_time, double moved_frames,
                     double first_time);
// A time that is on a frame but for rounding, on that frame.
double on_frame(const Timeline& timeline, double time);

// The shape of a key: a diamond is smooth, a square linear, a triangle constant.
QPolygonF key_shape(Interpolation interpolation, const QPointF& center, double radius);

}  // namespace brume
