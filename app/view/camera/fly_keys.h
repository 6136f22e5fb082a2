#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QTimer>
#include <glm/vec3.hpp>

namespace brume {

// The keys that fly through a scene while a button of the mouse is held: W and S forth and back, A
// and D to the left and right, E and Q up and down; Shift is fast, Ctrl slow. They are no shortcuts
// meanwhile.
class FlyKeys : public QObject {
  Q_OBJECT
 public:
  explicit FlyKeys(QObject* parent);

  void press();  // the button
  void release();
  [[nodiscard]] bool is_running() const { return is_running_; }
  // True if a key was pressed since the button was.
  [[nodiscard]] bool is_used() const { return is_used_; }

 Q_SIGNALS:
  // The way is to the right, up and forth, in seconds of flight at the usual speed.
  void moved(const glm::dvec3& way);
  void interrupted();  // released because the button's release will go elsewhere

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void move();

  bool is_running_ = false;
  bool is_used_ = false;
  QSet<int> held_;
  QTimer timer_;
  QElapsedTimer clock_;
};

}  // namespace brume
