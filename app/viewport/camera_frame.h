#pragma once

#include <QImage>
#include <QPixmap>
#include <QRectF>
#include <QWidget>
#include <memory>
#include <optional>

#include "render/display/plate_behind.h"

class QPainter;

namespace brume {

// The frame of the scene's camera over a view: outside it the picture is dark. A part of it can be
// marked by the mouse, as the only one to be rendered.
class CameraFrame : public QWidget {
  Q_OBJECT
 public:
  explicit CameraFrame(QWidget* pane);

  // The frame in the pane, with a title; nullopt: none.
  void show_frame(const std::optional<QRectF>& frame, const QString& title);

  // Sides of the safe areas over those of the picture.
  static constexpr double action_side = 0.9;
  static constexpr double title_side = 0.8;

  // Guides help to compose.
  struct Guides {
    bool thirds = false;
    bool safe_areas = false;  // of action and of titles
    bool plate = true;
    bool operator==(const Guides&) const = default;
  };
  [[nodiscard]] const Guides& guides() const { return guides_; }
  void set_guides(const Guides& guides);

  // A picture over that of the frame, as large as fits, or behind its fog; null: none.
  void set_plate(const QImage& plate, double opacity, bool is_behind);

  // The marked part, in fractions of the frame from its upper left corner; nullopt: none.
  [[nodiscard]] const std::optional<QRectF>& region() const { return region_; }
  void set_region(const std::optional<QRectF>& region);
  // The next drag of the left button marks a part; Escape and the right button end this.
  void start_marking();

 Q_SIGNALS:
  void region_changed();
  // The plate behind the fog of the whole pane; null: none.
  void plate_behind_changed(const std::shared_ptr<const brume::PlateBehind>& plate);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void end_marking();
  void paint_plate(QPainter& painter);
  void update_plate_behind();
  void draw_pane_plate();
  [[nodiscard]] QRectF plate_place() const;  // in the pane
  [[nodiscard]] bool shows_plate() const;
  void paint_guides(QPainter& painter) const;
  [[nodiscard]] QRectF marked() const;  // by the drag, in fractions of the frame
  [[nodiscard]] QRectF on_pane(const QRectF& region) const;

  std::optional<QRectF> frame_;
  QString title_;
  Guides guides_;
  QImage plate_;
  QPixmap scaled_plate_;  // as it was painted last
  double plate_opacity_ = 0.0;
  bool is_plate_behind_ = false;
  // The plate behind the fog was made of this last; no opacity: there is none.
  struct Behind {
    qint64 plate = 0;
    QRectF place;
    QSize pane;  // in pixels
    double opacity = 0.0;
    bool operator==(const Behind&) const = default;
    [[nodiscard]] bool has_picture_of(const Behind& other) const {
      return plate == other.plate && place == other.place && pane == other.pane;
    }
  };
  Behind behind_;
  QImage pane_plate_;  // its picture, the size of the pane
  std::optional<QRectF> region_;
  bool marks_ = false;
  std::optional<QPointF> start_;  // of the drag
  QPointF end_;
};

}  // namespace brume
