#pragma once

#include <QSlider>
#include <vector>

namespace brume {

// A horizontal slider that exposes its handle's position.
class FrameSlider : public QSlider {
  Q_OBJECT
 public:
  explicit FrameSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}

  // Center of the handle at a value [pixels from the left].
  [[nodiscard]] double x_of(int value) const;

  // A frame whose picture is kept: at full quality, or as it was in motion.
  struct Cached {
    int frame;
    bool full;
    bool operator==(const Cached&) const = default;
  };
  // Drawn as a bar below the groove.
  void set_cached(std::vector<Cached> frames);
  [[nodiscard]] const std::vector<Cached>& cached() const { return cached_; }

 Q_SIGNALS:
  void moved();  // its geometry has changed

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void moveEvent(QMoveEvent* event) override;

 private:
  std::vector<Cached> cached_;
};

}  // namespace brume
