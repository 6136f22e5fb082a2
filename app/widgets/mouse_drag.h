#pragma once

#include <QObject>
#include <QPointF>

namespace brume {

// A drag of the mouse, from the press of the left button to its release. What the hand slips in a
// click is no drag yet. Escape and the right button cancel it. Another key ends it before it acts,
// since what it changes may be what is dragged; unless it is a stroke, whose brush keys change.
class MouseDrag : public QObject {
  Q_OBJECT
 public:
  // A hand is not perfectly still in a click: of every handle, key and curve [pixels].
  static constexpr double max_slip = 4.0;

  explicit MouseDrag(QObject* parent) : QObject(parent) {}

  void press(QPointF position, bool is_stroke = false);
  void release();
  // Whether the button is down, and nothing has ended the drag since.
  [[nodiscard]] bool is_running() const { return is_running_; }
  // Whether the mouse at a position drags; from the first time on it does.
  [[nodiscard]] bool has_begun(QPointF position);

 Q_SIGNALS:
  void cancelled();
  void ended();  // by a key, as if the button had been released

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QPointF press_;
  bool is_stroke_ = false;
  bool is_down_ = false;
  bool is_running_ = false;
  bool has_begun_ = false;
};

}  // namespace brume
