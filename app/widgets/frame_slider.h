#pragma once

#include <QSlider>

namespace brume {

// A horizontal slider that exposes its handle's position.
class FrameSlider : public QSlider {
  Q_OBJECT
 public:
  explicit FrameSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}

  // Center of the handle at a value [pixels from the left].
  [[nodiscard]] double x_of(int value) const;

 Q_SIGNALS:
  void moved();  // its geometry has changed

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void moveEvent(QMoveEvent* event) override;
};

}  // namespace brume
