#include "app/viewport/camera_frame.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace brume {
namespace {

constexpr double min_drag = 4.0;  // pixels: less is a click, which marks nothing

QRectF unit_square() {
  return {0.0, 0.0, 1.0, 1.0};
}

}  // namespace

CameraFrame::CameraFrame(QWidget* pane) : QWidget(pane) {
  setObjectName("camera_frame");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  pane->installEventFilter(this);
  hide();
}

void CameraFrame::show_frame(const std::optional<QRectF>& frame, const QString& title) {
  frame_ = frame;
  title_ = title;
  if (!frame_) end_marking();
  setGeometry(parentWidget()->rect());
  setVisible(frame_.has_value());
  update_plate_behind();
  update();
}

void CameraFrame::set_guides(const Guides& guides) {
  guides_ = guides;
  update_plate_behind();
  update();
}

void CameraFrame::set_plate(const QImage& plate, double opacity, bool is_behind) {
  if (plate.cacheKey() != plate_.cacheKey()) scaled_plate_ = {};
  plate_ = plate;
  plate_opacity_ = opacity;
  is_plate_behind_ = is_behind;
  update_plate_behind();
  update();
}

bool CameraFrame::shows_plate() const {
  return frame_ && !plate_.isNull() && plate_opacity_ > 0.0 && guides_.plate;
}

QRectF CameraFrame::plate_place() const {
  QRectF place({}, QSizeF(plate_.size()).scaled(frame_->size(), Qt::KeepAspectRatio));
  place.moveCenter(frame_->center());
  return place;
}

void CameraFrame::update_plate_behind() {
  Behind behind;
  if (shows_plate() && is_plate_behind_) {
    behind = {plate_.cacheKey(), plate_place(),
              (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1}), plate_opacity_};
  }
  if (behind == behind_) return;
  const bool is_other = !behind.has_picture_of(behind_);
  behind_ = behind;
  if (behind.opacity == 0.0) {
    pane_plate_ = {};
    Q_EMIT plate_behind_changed(nullptr);
    return;
  }
  const QImage& pane = pane_plate_;
  if (is_other) draw_pane_plate();
  auto plate =
      std::make_shared<PlateBehind>(PlateBehind{pane.width(), pane.height(), {}, behind.opacity});
  plate->rgba.assign(pane.constBits(), pane.constBits() + pane.sizeInBytes());
  Q_EMIT plate_behind_changed(std::move(plate));
}

void CameraFrame::draw_pane_plate() {
  pane_plate_ = QImage(behind_.pane, QImage::Format_RGBA8888);
  pane_plate_.fill(Qt::transparent);
  QPainter painter(&pane_plate_);
  const double scale = devicePixelRatioF();
  const QSize pixels = (behind_.place.size() * scale).toSize().expandedTo({1, 1});
  painter.drawImage((behind_.place.topLeft() * scale).toPoint(),
                    plate_.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
}

void CameraFrame::set_region(const std::optional<QRectF>& region) {
  if (region == region_) return;
  region_ = region;
  update();
  Q_EMIT region_changed();
}

void CameraFrame::start_marking() {
  if (!frame_) return;
  marks_ = true;
  start_.reset();
  setAttribute(Qt::WA_TransparentForMouseEvents, false);
  setCursor(Qt::CrossCursor);
  setFocus();
  update();
}

void CameraFrame::end_marking() {
  if (!marks_) return;
  marks_ = false;
  start_.reset();
  setAttribute(Qt::WA_TransparentForMouseEvents);
  unsetCursor();
  parentWidget()->setFocus();
  update();
}

QRectF CameraFrame::marked() const {
  const auto fraction = [this](QPointF at) {
    return QPointF(std::clamp((at.x() - frame_->left()) / frame_->width(), 0.0, 1.0),
                   std::clamp((at.y() - frame_->top()) / frame_->height(), 0.0, 1.0));
  };
  return QRectF(fraction(*start_), fraction(end_)).normalized();
}

QRectF CameraFrame::on_pane(const QRectF& region) const {
  return {frame_->left() + region.left() * frame_->width(),
          frame_->top() + region.top() * frame_->height(), region.width() * frame_->width(),
          region.height() * frame_->height()};
}

void CameraFrame::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return end_marking();
  start_ = end_ = event->position();
}

void CameraFrame::mouseMoveEvent(QMouseEvent* event) {
  if (!start_) return;
  end_ = event->position();
  update();
}

void CameraFrame::mouseReleaseEvent(QMouseEvent* event) {
  if (!start_ || event->button() != Qt::LeftButton) return;
  end_ = event->position();
  const QRectF region = marked();
  const bool is_drag = QRectF(*start_, end_).normalized().width() >= min_drag &&
                       region.width() > 0.0 && region.height() > 0.0;
  end_marking();
  if (is_drag) set_region(region == unit_square() ? std::nullopt : std::optional(region));
}

void CameraFrame::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && marks_) return end_marking();
  QWidget::keyPressEvent(event);
}

bool CameraFrame::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    setGeometry(parentWidget()->rect());
    update_plate_behind();
  }
  return QWidget::eventFilter(watched, event);
}

void CameraFrame::paint_plate(QPainter& painter) {
  if (!shows_plate() || is_plate_behind_) return;
  const QRectF place = plate_place();
  const QSize pixels = (place.size() * devicePixelRatioF()).toSize().expandedTo({1, 1});
  if (scaled_plate_.size() != pixels) {
    scaled_plate_ =
        QPixmap::fromImage(plate_.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  }
  painter.setOpacity(plate_opacity_);
  painter.drawPixmap(place, scaled_plate_, scaled_plate_.rect());
  painter.setOpacity(1.0);
}

void CameraFrame::paint_guides(QPainter& painter) const {
  painter.setPen(QPen(QColor(235, 238, 242, 110), 1.0));
  if (guides_.thirds) {
    for (const double third : {1.0 / 3.0, 2.0 / 3.0}) {
      const QPointF place = on_pane({third, third, 0.0, 0.0}).topLeft();
      painter.drawLine(QPointF(place.x(), frame_->top()), QPointF(place.x(), frame_->bottom()));
      painter.drawLine(QPointF(frame_->left(), place.y()), QPointF(frame_->right(), place.y()));
    }
  }
  if (!guides_.safe_areas) return;
  for (const double side : {action_side, title_side}) {
    const double margin = 0.5 * (1.0 - side);
    painter.drawRect(on_pane({margin, margin, side, side}));
  }
}

void CameraFrame::paintEvent(QPaintEvent* /*event*/) {
  if (!frame_) return;
  QPainter painter(this);
  paint_plate(painter);
  QPainterPath outside;
  outside.addRect(rect());
  QPainterPath inside;
  inside.addRect(*frame_);
  painter.fillPath(outside.subtracted(inside), QColor(0, 0, 0, 150));
  painter.setPen(QPen(QColor(235, 238, 242, 200), 1.0));
  painter.drawRect(*frame_);
  painter.drawText(QPointF(frame_->left() + 2.0, std::max(frame_->top() - 5.0, 12.0)), title_);
  paint_guides(painter);
  const std::optional<QRectF> region = start_ ? std::optional(marked()) : region_;
  if (region) {
    painter.setPen(QPen(QColor(255, 170, 60), 1.5, Qt::DashLine));
    painter.drawRect(on_pane(*region));
  }
  if (marks_ && !start_) {
    painter.setPen(QColor(255, 170, 60));
    painter.drawText(frame_->adjusted(0, 10, 0, 0), Qt::AlignTop | Qt::AlignHCenter,
                     tr("Drag over what to render. Escape ends"));
  }
}

}  // namespace brume
