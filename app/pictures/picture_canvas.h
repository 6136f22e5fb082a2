#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "app/pictures/picture.h"

namespace brume {

// Shows a picture A, or A left and B right of a line that the mouse drags, or their difference. The
// wheel zooms, a drag elsewhere pans.
class PictureCanvas : public QWidget {
  Q_OBJECT
 public:
  enum class Mode { single, wipe, difference };
  explicit PictureCanvas(QWidget* parent = nullptr);

  // Either may be null.
  void show_pictures(std::shared_ptr<const Picture> a, std::shared_ptr<const Picture> b);
  void set_mode(Mode mode);
  [[nodiscard]] Mode mode() const { return mode_; }
  // Their difference; null: it is not known yet, or there is none.
  void show_difference(const QImage& difference);

  void fit();          // the whole picture, also when the canvas changes its size
  void actual_size();  // a pixel of it on a pixel of the screen

  // The line between A and B, as a fraction of the picture's width.
  [[nodiscard]] double divider() const { return divider_; }
  // Where A is, in widget coordinates.
  [[nodiscard]] QRectF picture_rect() const;
  // The pixel of A at a position; nullopt outside.
  [[nodiscard]] std::optional<QPoint> pixel_at(QPointF position) const;

 Q_SIGNALS:
  void pointed_at(std::optional<QPoint> pixel);  // of A

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  enum class Drag { none, pan, divider };
  [[nodiscard]] bool is_on_divider(QPointF position) const;
  [[nodiscard]] double divider_x() const;

  std::shared_ptr<const Picture> a_;
  std::shared_ptr<const Picture> b_;
  Mode mode_ = Mode::single;
  QImage difference_;
  double divider_ = 0.5;
  bool fits_ = true;
  double zoom_ = 1.0;  // widget pixels per picture pixel
  QPointF center_;     // of the widget, in picture pixels
  Drag drag_ = Drag::none;
  QPointF last_position_;
};

}  // namespace brume
