#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <optional>
#include <vector>

#include "app/view/camera/fly_keys.h"
#include "app/view/camera/navigation.h"
#include "app/widgets/mouse_drag.h"

class QMouseEvent;

namespace brume {

class Tool;
class View;

// Mouse input of a view: camera or tool drags, and flights while the right button is held. Moves
// are collected and delivered together once the event queue is empty: no position is lost, and slow
// views do not lag behind.
class ViewInput : public QObject {
  Q_OBJECT
 public:
  explicit ViewInput(View& view);

  // Cancels a running gesture. nullptr: none.
  void set_tool(Tool* tool);
  [[nodiscard]] Tool* tool() const { return tool_; }

  // A pen and its pressure, from 0 to 1; call before the event of the mouse that it becomes.
  void set_pen(bool is_down, double pressure);
  void enter();
  void press(const QMouseEvent& event);
  void move(QPointF position);
  void release(const QMouseEvent& event);
  void turn_wheel(double angle);  // in eighths of degrees
  void leave();
  // Ends the gesture on behalf of the tool.
  void end_gesture();

  // Delivers collected moves now.
  void flush_moves();

 Q_SIGNALS:
  void pointed_at(QPointF position);  // with no button down
  void menu_asked(QPointF position);  // a click of the right button

 private:
  enum class Drag { none, camera, flight, tool };
  void start_drag(const QMouseEvent& event);
  void release_tool();
  void cancel();

  View& view_;
  Tool* tool_ = nullptr;
  Drag drag_ = Drag::none;
  MouseDrag tool_drag_{this};
  FlyKeys fly_keys_{this};
  double fly_speed_ = 0.5;  // distances per second
  NavigationDrag camera_drag_ = NavigationDrag::orbit;
  std::vector<QPointF> path_;  // collected mouse positions
  QPointF last_position_;
  bool pen_is_down_ = false;
  double pressure_ = 1.0;  // of the pen; 1 for the mouse
  QTimer timer_;
  std::optional<QPointF> right_press_;
};

}  // namespace brume
