#include "app/panels/curve_editor.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/commands/edit_keys.h"
#include "app/document/document.h"
#include "app/document/timeline.h"
#include "app/panels/key_menu.h"
#include "app/widgets/application.h"

namespace brume {
namespace {

constexpr double point_radius = 4.0;  // pixels

// Red, green, blue as the axes; further values of a track are dashed.
QPen curve_pen(const std::vector<Curve>& curves, std::size_t k) {
  static constexpr std::array colors{0xe0605a, 0x4fae57, 0x5b8def};
  const Curve& curve = curves[k];
  QPen pen(QColor(QRgb(colors.at(static_cast<std::size_t>(curve.component)))), 1.6);
  const std::size_t of_track = curve.value - curves.front().value;
  if (of_track == 1) pen.setStyle(Qt::DashLine);
  if (of_track == 2) pen.setStyle(Qt::DotLine);
  return pen;
}

// 1, 2 or 5 times a power of ten, at least `step`.
double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

CurveEditor::CurveEditor(Timeline& timeline, Document& document, QWidget* parent)
    : QWidget(parent), timeline_(timeline), document_(document) {
  setFocusPolicy(Qt::ClickFocus);
  setToolTip(
      tr("Drag a key in time and value, Del to delete, right-click for options, double-click to "
         "add one. Wheel to zoom (Shift: time only, Ctrl: value only), middle button to pan, Home "
         "to fit."));
  connect(&document_, &Document::scene_replaced, this, [this] {
    drag_.reset();
    chosen_.reset();
    refresh();
  });
  connect(&document_, &Document::part_changed, this, &CurveEditor::refresh);
  connect(&timeline_, &Timeline::changed, this, qOverload<>(&QWidget::update));
}

void CurveEditor::set_track(const std::optional<Track>& row) {
  row_ = row;
  drag_.reset();
  chosen_.reset();
  refresh();
  fit();
}

void CurveEditor::refresh() {
  curves_ = row_ ? curves_of(document_.scene(), *row_) : std::vector<Curve>();
  if (chosen_ && chosen_->curve >= curves_.size()) chosen_.reset();
  update();
}

void CurveEditor::fit() {
  if (curves_.empty()) return;
  double begin = timeline_.time_of(timeline_.first());
  double end = timeline_.time_of(timeline_.last());
  double low = curves_.front().points().front().value;
  double high = low;
  for (const Curve& curve : curves_) {
    for (const Curve::Point& point : curve.points()) {
      begin = std::min(begin, point.time);
      end = std::max(end, point.time);
      low = std::min(low, point.value);
      high = std::max(high, point.value);
    }
  }
  // A constant has no range of its own.
  const double range = high > low ? high - low : std::max(1.0, std::abs(high));
  const double length = std::max(end - begin, timeline_.time_of(1));
  const double middle = 0.5 * (low + high);
  constexpr double margin = 0.1;
  shown_ = QRectF(begin - 0.03 * length, middle - (0.5 + margin) * range, 1.06 * length,
                  (1.0 + 2.0 * margin) * range);
  update();
}

QPointF CurveEditor::position(double time, double value) const {
  return {(time - shown_.left()) / shown_.width() * width(),
          (shown_.bottom() - value) / shown_.height() * height()};
}

double CurveEditor::time_at(double x) const {
  return shown_.left() + x / std::max(1, width()) * shown_.width();
}

double CurveEditor::value_of(double y) const {
  return shown_.bottom() - y / std::max(1, height()) * shown_.height();
}

int CurveEditor::frame_near(double x) const {
  const double last = std::max(timeline_.last(), timeline_.frame());
  return static_cast<int>(
      std::clamp(std::round(timeline_.frame_of(time_at(x))), 0.0, std::max(last, 0.0)));
}

std::optional<CurveEditor::Mark> CurveEditor::mark_near(QPointF at) const {
  std::optional<Mark> nearest;
  double min_value = point_radius + 3.0;
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    for (const Curve::Point& point : curves_[k].points()) {
      const QPointF offset = position(point.time, point.value) - at;
      const double distance = std::hypot(offset.x(), offset.y());
      if (distance > min_value) continue;
      min_value = distance;
      nearest = Mark{k, point.time};
    }
  }
  return nearest;
}

void CurveEditor::paint_grid(QPainter& painter) const {
  constexpr double between_lines = 60.0;  // pixels
  QColor line = palette().color(QPalette::Text);
  QColor text = line;
  line.setAlphaF(0.12F);
  text.setAlphaF(0.6F);
  const double frames = timeline_.frame_of(shown_.width());
  const double column = std::max(1.0, round_step(frames * between_lines / width()));
  const double left = timeline_.frame_of(shown_.left());
  for (double f = std::ceil(left / column) * column; f <= left + frames; f += column) {
    const double x = position(timeline_.time_of(f), 0.0).x();
    painter.setPen(line);
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setPen(text);
    painter.drawText(QPointF(x + 3, height() - 4), QString::number(f));
  }
  const double row = round_step(shown_.height() * 0.7 * between_lines / height());
  const double first_row = std::ceil(shown_.top() / row);
  for (double k = first_row; k * row <= shown_.bottom(); ++k) {
    const double y = position(0.0, k * row).y();
    painter.setPen(line);
    painter.drawLine(QPointF(0, y), QPointF(width(), y));
    painter.setPen(text);
    painter.drawText(QPointF(4, y - 3), QString::number(k * row, 'g', 5));
  }
}

void CurveEditor::paint_curve(QPainter& painter, std::size_t k) const {
  const Curve& curve = curves_[k];
  QPainterPath path;
  constexpr int step = 2;  // pixels
  for (int x = 0; x <= width() + step; x += step) {
    const QPointF at = position(time_at(x), curve.at(time_at(x)));
    x == 0 ? path.moveTo(at) : path.lineTo(at);
  }
  QPen pen = curve_pen(curves_, k);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawPath(path);
  for (const Curve::Point& point : curve.points()) {
    const QPointF at = position(point.time, point.value);
    const bool chosen =
        chosen_ && chosen_->curve == k && std::abs(chosen_->time - point.time) < min_key_distance;
    painter.setPen(QPen(palette().color(chosen ? QPalette::Text : QPalette::Base), 1.5));
    painter.setBrush(pen.color());
    const double r = chosen ? point_radius + 1.5 : point_radius;
    if (point.interpolation == Interpolation::smooth) {
      const QPointF corners[]{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r),
                              at + QPointF(-r, 0)};
      painter.drawConvexPolygon(corners, 4);
    } else {
      painter.drawRect(QRectF(at.x() - 0.8 * r, at.y() - 0.8 * r, 1.6 * r, 1.6 * r));
    }
  }
}

void CurveEditor::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (curves_.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Nothing is animated yet. Choose a value at the right of the timeline and "
                        "press I to set its first keyframe."));
    return;
  }
  paint_grid(painter);
  painter.setPen(QPen(accent_color(), 1.5));
  const double now = position(timeline_.time(), 0.0).x();
  painter.drawLine(QPointF(now, 0), QPointF(now, height()));
  for (std::size_t k = 0; k < curves_.size(); ++k) paint_curve(painter, k);
  double x = width() - 8.0;
  for (std::size_t k = curves_.size(); k-- > 0;) {
    x -= fontMetrics().horizontalAdvance(curves_[k].title) + 10.0;
    painter.setPen(curve_pen(curves_, k).color());
    painter.drawText(QPointF(x, fontMetrics().height()), curves_[k].title);
  }
}

void CurveEditor::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) {
    pan_ = event->position();
    return;
  }
  if (curves_.empty()) return;
  chosen_ = mark_near(event->position());
  if (event->button() == Qt::LeftButton) {
    if (chosen_) {
      drag_ = Drag{scene_part(document_.scene(), row_->part),
                   chosen_->time,
                   curves_[chosen_->curve].at(chosen_->time),
                   chosen_->time,
                   event->position(),
                   new_merge_id()};
    } else {
      scrubs_ = true;
      timeline_.set_frame(frame_near(event->position().x()));
    }
  }
  update();
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (pan_) {
    const QPointF moved = at - *pan_;
    shown_.translate(-moved.x() / std::max(1, width()) * shown_.width(),
                     moved.y() / std::max(1, height()) * shown_.height());
    pan_ = at;
    update();
  }
  if (scrubs_) timeline_.set_frame(frame_near(at.x()));
  if (!drag_ || !chosen_) return;
  const QPointF moved = at - drag_->press;
  // A key between two frames stays there until it is moved.
  const double frames =
      std::round(timeline_.frame_of(moved.x() / std::max(1, width()) * shown_.width()));
  const double old_frame = timeline_.frame_of(drag_->from);
  const double to = frames == 0.0
                        ? drag_->from
                        : timeline_.time_of(std::max(0.0, std::round(old_frame + frames)));
  const double value = drag_->value - moved.y() / std::max(1, height()) * shown_.height();
  drag_->to = to;
  chosen_->time = to;
  move_curve_key(document_, *row_, curves_[chosen_->curve], drag_->before,
                 {drag_->from, drag_->to, value}, drag_->gesture);
}

void CurveEditor::mouseReleaseEvent(QMouseEvent*) {
  drag_.reset();
  pan_.reset();
  scrubs_ = false;
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || curves_.empty()) return;
  const std::optional<Mark> mark = mark_near(event->position());
  const int frame = mark ? static_cast<int>(std::round(timeline_.frame_of(mark->time)))
                         : frame_near(event->position().x());
  timeline_.set_frame(frame);
  if (!mark) set_keys(document_, *row_);
}

void CurveEditor::wheelEvent(QWheelEvent* event) {
  // Qt turns the wheel sideways with some keys.
  const QPoint angle = event->angleDelta();
  const double factor = std::pow(0.999, angle.y() != 0 ? angle.y() : angle.x());
  const QPointF at = event->position();
  const double time = time_at(at.x());
  const double value = value_of(at.y());
  const double in_time = event->modifiers() & Qt::ControlModifier ? 1.0 : factor;
  const double in_value = event->modifiers() & Qt::ShiftModifier ? 1.0 : factor;
  const double width = std::clamp(shown_.width() * in_time, 1e-3, 1e6);
  const double height = std::clamp(shown_.height() * in_value, 1e-9, 1e12);
  shown_ = QRectF(time - (time - shown_.left()) * width / shown_.width(),
                  value - (value - shown_.top()) * height / shown_.height(), width, height);
  update();
  event->accept();
}

void CurveEditor::contextMenuEvent(QContextMenuEvent* event) {
  chosen_ = mark_near(event->pos());
  update();
  if (!chosen_) return;
  show_key_menu(
      *this, document_, *row_, chosen_->time, [this] { delete_chosen(); }, event->globalPos());
}

void CurveEditor::delete_chosen() {
  if (!chosen_) return;
  const double time = chosen_->time;
  chosen_.reset();
  drag_.reset();
  delete_keys(document_, *row_, time);
}

// Delete and Home are shortcuts of the window too.
bool CurveEditor::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Delete && chosen_) ||
        (key == Qt::Key_Home && static_cast<QKeyEvent*>(event)->modifiers() == Qt::NoModifier)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void CurveEditor::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete && chosen_) {
    delete_chosen();
  } else if (event->key() == Qt::Key_Home && event->modifiers() == Qt::NoModifier) {
    fit();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace brume
