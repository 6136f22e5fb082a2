#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <vector>

class QMouseEvent;

namespace brume {

class Tool;
class Viewport;

// What the mouse does in a view: a drag of the camera, or one of the tool. Moves are collected, and
// handed on together once no more of them wait: every position counts, and yet no view, however
// slow, falls behind the mouse.
class ViewInput : public QObject {
  Q_OBJECT
 public:
  explicit ViewInput(Viewport& view);

  // A gesture in flight is cancelled. nullptr: none.
  void set_tool(Tool* tool);
  [[nodiscard]] Tool* tool() const { return tool_; }

  void enter();
  void press(const QMouseEvent& event);
  void move(QPointF position);
  void release(const QMouseEvent& event);
  void leave();
  // Whether there was a gesture of the tool.
  bool cancel();
  // Ends a gesture of the tool, who knows of it.
  void end_gesture();

  // Hands on what has been collected, now.
  void hand_on();

 Q_SIGNALS:
  void pointed_at(QPointF position);  // with no button down

 private:
  enum class Drag { none, orbit, pan, zoom, tool };
  [[nodiscard]] Drag drag_of(const QMouseEvent& event) const;

  Viewport& view_;
  Tool* tool_ = nullptr;
  Drag drag_ = Drag::none;
  std::vector<QPointF> path_;  // where the mouse was, not handed on yet
  QPointF last_position_;
  QTimer timer_;
};

}  // namespace brume
