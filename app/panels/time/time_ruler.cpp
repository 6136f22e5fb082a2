#include "app/panels/time/time_ruler.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/document/text/number_text.h"
#include "app/document/time/timeline.h"
#include "app/widgets/application.h"

namespace brume {
namespace {

constexpr double end_margin = 12.0;  // pixels, so that keys at the ends are whole

}  // namespace

double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step) return factor * power;
  }
  return 10.0 * power;
}

FrameScale::FrameScale(const Timeline& timeline, double left, double width)
    : timeline_(timeline), left_(left), width_(width) {
  const FrameSpan shown = timeline.shown();
  first_ = shown.first;
  frames_per_pixel_ = (shown.last - shown.first) / std::max(1.0, width - 2.0 * end_margin);
}

double FrameScale::x_of(double frame) const {
  return left_ + end_margin + (frame - first_) / frames_per_pixel_;
}

double FrameScale::frame_at(double x) const {
  return first_ + (x - left_ - end_margin) * frames_per_pixel_;
}

int FrameScale::scrub_frame(double x) const {
  const double last = std::max({timeline_.last(), timeline_.frame(), 0});
  return static_cast<int>(std::clamp(std::round(frame_at(x)), 0.0, last));
}

std::vector<double> FrameScale::ticks() const {
  constexpr double min_distance = 56.0;  // pixels
  const double step = std::max(1.0, round_step(min_distance * frames_per_pixel_));
  const double end = frame_at(left_ + width_);
  std::vector<double> frames;
  for (double k = std::ceil(frame_at(left_) / step); k * step <= end; ++k) {
    frames.push_back(k * step);
  }
  return frames;
}

void FrameScale::paint_lines(QPainter& painter, const QWidget& widget) const {
  const double height = widget.height();
  QColor line = widget.palette().color(QPalette::Text);
  QColor shade = line;
  line.setAlphaF(0.12F);
  shade.setAlphaF(0.05F);
  const double begin = std::clamp(x_of(timeline_.first()), left_, left_ + width_);
  const double end = std::clamp(x_of(timeline_.last()), left_, left_ + width_);
  painter.fillRect(QRectF(left_, 0.0, begin - left_, height), shade);
  painter.fillRect(QRectF(end, 0.0, left_ + width_ - end, height), shade);
  painter.setPen(line);
  for (const double frame : ticks()) {
    painter.drawLine(QPointF(x_of(frame), 0.0), QPointF(x_of(frame), height));
  }
  const double now = x_of(timeline_.frame());
  if (now < left_ || now > left_ + width_) return;
  painter.setPen(QPen(accent_color(), 1.5));
  painter.drawLine(QPointF(now, 0.0), QPointF(now, height));
}

void zoom_frames(Timeline& timeline, const FrameScale& scale, double x, double factor) {
  const FrameSpan shown = timeline.shown();
  const double fixed = scale.frame_at(x);
  timeline.show_frames(
      FrameSpan{fixed + factor * (shown.first - fixed), fixed + factor * (shown.last - fixed)});
}

void pan_frames(Timeline& timeline, const FrameScale& scale, double pixels) {
  const FrameSpan shown = timeline.shown();
  const double shift = -pixels * scale.frames_per_pixel();
  timeline.show_frames(FrameSpan{shown.first + shift, shown.last + shift});
}

void fit_frames(Timeline& timeline, double last_key) {
  timeline.show_frames(std::nullopt);
  const FrameSpan range = timeline.shown();
  const double last = timeline.frame_of(last_key);
  if (last > range.last || range.first > 0.0) {
    timeline.show_frames(FrameSpan{0.0, std::max(last, range.last)});
  }
}

void paint_rubber_band(QPainter& painter, const QRectF& area) {
  QColor fill = accent_color();
  painter.setPen(QPen(fill, 1.0, Qt::DashLine));
  fill.setAlphaF(0.15F);
  painter.setBrush(fill);
  painter.drawRect(area.normalized());
}

TimeRuler::TimeRuler(Timeline& timeline, QWidget* parent) : QWidget(parent), timeline_(timeline) {
  setFixedHeight(ruler_height);
  setMinimumWidth(120);
  setAccessibleName(tr("Frames"));
  setToolTip(
      tr("Drag to another frame. Wheel to zoom, middle button to pan, double-click to show the "
         "range. The bar below shows which frames are cached: bright at full quality, dim as they "
         "were shown during playback."));
  connect(&timeline_, &Timeline::changed, this, qOverload<>(&QWidget::update));
}

FrameScale TimeRuler::scale() const {
  return {timeline_, 0.0, static_cast<double>(width())};
}

void TimeRuler::set_cached(std::vector<Cached> frames) {
  if (frames == cached_) return;
  cached_ = std::move(frames);
  update();
}

void TimeRuler::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::AlternateBase));
  const FrameScale shown = scale();
  shown.paint_lines(painter, *this);
  paint_cached(painter);
  painter.setPen(palette().color(QPalette::Text));
  for (const double frame : shown.ticks()) {
    painter.drawText(QPointF(shown.x_of(frame) + 3.0, fontMetrics().ascent() + 2.0),
                     number_text(frame));
  }
  // The head of the playhead is what one takes hold of.
  const double now = shown.x_of(timeline_.frame());
  constexpr double head = 6.0;  // pixels
  painter.setPen(Qt::NoPen);
  painter.setBrush(accent_color());
  painter.drawConvexPolygon(QPolygonF{
      QPointF(now - head, 0.0), QPointF(now + head, 0.0), QPointF(now + head, 0.4 * height()),
      QPointF(now, 0.7 * height()), QPointF(now - head, 0.4 * height())});
}

void TimeRuler::paint_cached(QPainter& painter) const {
  constexpr double thickness = 3.0;  // pixels
  const FrameScale shown = scale();
  const double step = 1.0 / shown.frames_per_pixel();
  QColor draft = accent_color();
  draft.setAlphaF(0.4F);
  for (const Cached& cached : cached_) {
    painter.fillRect(QRectF(shown.x_of(cached.frame) - 0.5 * step, height() - thickness,
                            std::max(step, 1.0), thickness),
                     cached.full ? accent_color() : draft);
  }
}

void TimeRuler::scrub_to(double x) {
  timeline_.set_frame(scale().scrub_frame(x));
}

void TimeRuler::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) pan_x_ = event->position().x();
  if (event->button() == Qt::LeftButton) scrub_to(event->position().x());
}

void TimeRuler::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (pan_x_) {
    pan_frames(timeline_, scale(), x - *pan_x_);
    pan_x_ = x;
  } else if (event->buttons() & Qt::LeftButton) {
    scrub_to(x);
  }
}

void TimeRuler::mouseReleaseEvent(QMouseEvent*) {
  pan_x_.reset();
}

void TimeRuler::mouseDoubleClickEvent(QMouseEvent*) {
  timeline_.show_frames(std::nullopt);
}

void TimeRuler::wheelEvent(QWheelEvent* event) {
  zoom_frames(timeline_, scale(), event->position().x(), std::pow(0.999, event->angleDelta().y()));
  event->accept();
}

}  // namespace brume
