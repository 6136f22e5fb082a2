#include "app/pictures/picture_canvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace brume {
namespace {

constexpr double grab_distance = 6.0;  // from the divider [pixels]
constexpr double min_zoom = 0.02;
constexpr double max_zoom = 64.0;
constexpr double smooth_below = 2.0;  // from this zoom on pixels are shown as squares

}  // namespace

PictureCanvas::PictureCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName("picture_canvas");
  setMouseTracking(true);
  setMinimumSize(200, 150);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PictureCanvas::show_pictures(std::shared_ptr<const Picture> a,
                                  std::shared_ptr<const Picture> b) {
  const bool same_size = a && a_ && a->width == a_->width && a->height == a_->height;
  a_ = std::move(a);
  b_ = std::move(b);
  difference_ = {};
  if (!same_size || fits_) fit();
  update();
}

void PictureCanvas::set_mode(Mode mode) {
  mode_ = mode;
  update();
}

void PictureCanvas::show_difference(const QImage& difference) {
  difference_ = difference;
  update();
}

void PictureCanvas::fit() {
  fits_ = true;
  if (!a_) return;
  zoom_ = std::min({static_cast<double>(width()) / a_->width,
                    static_cast<double>(height()) / a_->height, max_zoom});
  center_ = {0.5 * a_->width, 0.5 * a_->height};
  update();
}

void PictureCanvas::actual_size() {
  fits_ = false;
  zoom_ = 1.0 / devicePixelRatioF();
  update();
}

QRectF PictureCanvas::picture_rect() const {
  if (!a_) return {};
  const QPointF corner = QPointF(0.5 * width(), 0.5 * height()) - zoom_ * center_;
  return {corner, zoom_ * QSizeF(a_->width, a_->height)};
}

std::optional<QPoint> PictureCanvas::pixel_at(QPointF position) const {
  const QRectF rect = picture_rect();
  if (!a_ || !rect.contains(position)) return std::nullopt;
  const QPointF pixel = (position - rect.topLeft()) / zoom_;
  return QPoint(std::min(static_cast<int>(pixel.x()), a_->width - 1),
                std::min(static_cast<int>(pixel.y()), a_->height - 1));
}

double PictureCanvas::divider_x() const {
  const QRectF rect = picture_rect();
  return rect.left() + divider_ * rect.width();
}

bool PictureCanvas::is_on_divider(QPointF position) const {
  return mode_ == Mode::wipe && a_ && b_ && std::abs(position.x() - divider_x()) <= grab_distance;
}

void PictureCanvas::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(24, 24, 26));
  if (!a_) {
    painter.setPen(QColor(170, 173, 178));
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Nothing in this slot yet. F12 renders a picture into it; Keep View keeps "
                        "what the view shows. Then choose two of them as A and B to compare."));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom_ < smooth_below);
  const QRectF all = picture_rect();
  if (mode_ == Mode::difference && b_) {
    if (!difference_.isNull()) return painter.drawImage(all, difference_);
    if (a_->width != b_->width || a_->height != b_->height) {
      painter.setPen(QColor(235, 238, 242));
      painter.drawText(rect(), Qt::AlignCenter, tr("A and B differ in size."));
    }
    return;
  }
  painter.drawImage(all, a_->image);
  if (mode_ != Mode::wipe || !b_) return;
  const double x = divider_x();
  painter.save();
  painter.setClipRect(QRectF(x, 0.0, std::max(0.0, width() - x), height()));
  painter.fillRect(rect(), QColor(24, 24, 26));
  painter.drawImage(all, b_->image);
  painter.restore();
  painter.setPen(QPen(QColor(255, 255, 255, 220), 1.0));
  painter.drawLine(QPointF(x, all.top()), QPointF(x, all.bottom()));
  const double y = std::clamp(all.center().y(), 20.0, height() - 20.0);
  painter.setBrush(QColor(255, 255, 255, 220));
  painter.drawEllipse(QPointF(x, y), 4.0, 4.0);
  const auto letter = [&](const QString& text, double left) {
    const QRectF box(left, std::max(all.top(), 0.0) + 6.0, 18.0, 18.0);
    painter.fillRect(box, QColor(0, 0, 0, 150));
    painter.drawText(box, Qt::AlignCenter, text);
  };
  letter("A", x - 24.0);
  letter("B", x + 6.0);
}

void PictureCanvas::resizeEvent(QResizeEvent* /*event*/) {
  if (fits_) fit();
}

void PictureCanvas::mousePressEvent(QMouseEvent* event) {
  last_position_ = event->position();
  const bool takes_divider = event->button() == Qt::LeftButton && is_on_divider(event->position());
  drag_ = takes_divider ? Drag::divider : Drag::pan;
}

void PictureCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = event->position();
  if (drag_ == Drag::divider) {
    const QRectF rect = picture_rect();
    divider_ = std::clamp((position.x() - rect.left()) / rect.width(), 0.0, 1.0);
    update();
  } else if (drag_ == Drag::pan && a_) {
    fits_ = false;
    center_ -= (position - last_position_) / zoom_;
    update();
  }
  last_position_ = position;
  setCursor(drag_ == Drag::divider || is_on_divider(position) ? Qt::SplitHCursor : Qt::CrossCursor);
  Q_EMIT pointed_at(pixel_at(position));
}

void PictureCanvas::mouseReleaseEvent(QMouseEvent* /*event*/) {
  drag_ = Drag::none;
}

void PictureCanvas::leaveEvent(QEvent* /*event*/) {
  Q_EMIT pointed_at(std::nullopt);
}

void PictureCanvas::wheelEvent(QWheelEvent* event) {
  if (!a_) return;
  const QPointF from_center = event->position() - QPointF(0.5 * width(), 0.5 * height());
  const QPointF fixed_point = center_ + from_center / zoom_;
  fits_ = false;
  zoom_ = std::clamp(zoom_ * std::pow(1.0015, event->angleDelta().y()), min_zoom, max_zoom);
  center_ = fixed_point - from_center / zoom_;  // what is under the mouse stays there
  update();
  event->accept();
}

}  // namespace brume
