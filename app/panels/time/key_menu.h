#pragma once

#include <QPolygonF>
#include <QString>
#include <functional>
#include <vector>

#include "app/document/keyframe_tracks.h"

class QWidget;

namespace brume {

class Document;

struct KeyAction {
  QString text;
  std::function<void()> run;
};

// Shows the menu of keys of a track at some times, the first of which it says the state of:
// interpolation, tangents, and further actions.
void show_key_menu(QWidget& owner, Document& document, const Track& row,
                   const std::vector<double>& times, const std::vector<KeyAction>& actions,
                   const QPoint& global_position);

// How a key is drawn: a diamond is smooth, a square linear, a triangle constant.
QPolygonF key_shape(Interpolation interpolation, const QPointF& center, double radius);

}  // namespace brume
