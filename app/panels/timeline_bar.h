#pragma once

#include <QWidget>

namespace brume {

class Timeline;

// The timeline as a row: play, step, the frame on a slider, the range, loop.
class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  TimelineBar(Timeline& timeline, QWidget* parent);
};

}  // namespace brume
