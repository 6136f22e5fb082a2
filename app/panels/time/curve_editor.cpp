#include "app/panels/time/curve_editor.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/commands/edit_keys.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/timeline.h"
#include "app/panels/time/key_menu.h"
#include "app/widgets/application.h"
#include "app/widgets/keys.h"

namespace brume {
namespace {

constexpr double point_radius = 4.0;   // pixels
constexpr double handle_radius = 3.0;  // pixels

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

}  // namespace

CurveEditor::CurveEditor(Timeline& timeline, Document& document, QWidget* parent)
    : QWidget(parent), timeline_(timeline), document_(document) {
  setFocusPolicy(Qt::ClickFocus);
  setToolTip(
      tr("Drag keys in time and value, and the ends of their tangents (Alt: one side alone). Shift "
         "or a rectangle selects several. Del to delete, right-click for options, double-click to "
         "add a key. Drag along the frame numbers to scrub. Wheel to zoom (Shift: time only, Ctrl: "
         "value only), middle button to pan, Home to fit."));
  on_change(document_, Change::scene, this, [this] {
    drag_ = {};
    selection_.set({});
    refresh();
  });
  on_change(document_, Change::part, this, &CurveEditor::refresh);
  connect(&timeline_, &Timeline::changed, this, qOverload<>(&QWidget::update));
  connect(&mouse_, &MouseDrag::cancelled, this, &CurveEditor::cancel_drag);
  connect(&mouse_, &MouseDrag::ended, this, [this] { drag_ = {}; });
}

void CurveEditor::set_track(const std::optional<Track>& row) {
  row_ = row;
  drag_ = {};
  selection_.set({});
  refresh();
  fit();
}

void CurveEditor::refresh() {
  curves_ = row_ ? curves_of(document_.scene(), *row_) : std::vector<Curve>();
  selection_.prune(curves_);
  update();
}

void CurveEditor::fit() {
  axes_.fit(curves_, timeline_);
  update();
}

void CurveEditor::resizeEvent(QResizeEvent*) {
  axes_.set_size(size());
}

int CurveEditor::frame_near(double x) const {
  const double last = std::max(timeline_.last(), timeline_.frame());
  return static_cast<int>(
      std::clamp(std::round(timeline_.frame_of(axes_.time_at(x))), 0.0, std::max(last, 0.0)));
}

double CurveEditor::on_frame(double time) const {
  const double nearest = timeline_.time_of(std::round(timeline_.frame_of(time)));
  return std::abs(nearest - time) < min_key_distance ? nearest : time;
}

double CurveEditor::value_of(const CurveMark& mark) const {
  for (const Curve::Point& point : curves_[mark.curve].points()) {
    if (mark.is({mark.curve, point.time})) return point.value;
  }
  return 0.0;
}

void CurveEditor::paint_curve(QPainter& painter, std::size_t k) const {
  const Curve& curve = curves_[k];
  QPainterPath path;
  constexpr int step = 2;  // pixels
  for (int x = 0; x <= width() + step; x += step) {
    const QPointF curve_point = position(axes_.time_at(x), curve.at(axes_.time_at(x)));
    x == 0 ? path.moveTo(curve_point) : path.lineTo(curve_point);
  }
  const QPen pen = curve_pen(curves_, k);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawPath(path);
  for (const Curve::Point& point : curve.points()) {
    const bool selected = selection_.contains({k, point.time});
    painter.setPen(QPen(palette().color(selected ? QPalette::Text : QPalette::Base), 1.5));
    painter.setBrush(pen.color());
    painter.drawConvexPolygon(key_shape(point.interpolation, position(point.time, point.value),
                                        selected ? point_radius + 1.5 : point_radius));
  }
}

void CurveEditor::paint_handles(QPainter& painter) const {
  for (const TangentHandle& handle : handles()) {
    const QColor color = curve_pen(curves_, handle.mark.curve).color();
    painter.setPen(QPen(color, 1.2, handle.is_automatic ? Qt::DotLine : Qt::SolidLine));
    painter.drawLine(handle.key, handle.tip);
    painter.setPen(QPen(color, 1.2));
    painter.setBrush(handle.is_automatic ? palette().color(QPalette::Base) : color);
    painter.drawEllipse(handle.tip, handle_radius, handle_radius);
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
  axes_.paint_grid(painter, palette(), timeline_);
  painter.setPen(QPen(accent_color(), 1.5));
  const double now = position(timeline_.time(), 0.0).x();
  painter.drawLine(QPointF(now, 0), QPointF(now, height()));
  paint_handles(painter);
  for (std::size_t k = 0; k < curves_.size(); ++k) paint_curve(painter, k);
  double x = width() - 8.0;
  for (std::size_t k = curves_.size(); k-- > 0;) {
    x -= fontMetrics().horizontalAdvance(curves_[k].title) + 10.0;
    painter.setPen(curve_pen(curves_, k).color());
    painter.drawText(QPointF(x, fontMetrics().height()), curves_[k].title);
  }
  if (const auto* drawn = std::get_if<RectangleDrag>(&drag_)) {
    QColor fill = accent_color();
    painter.setPen(QPen(fill, 1.0, Qt::DashLine));
    fill.setAlphaF(0.15F);
    painter.setBrush(fill);
    painter.drawRect(QRectF(drawn->press, drawn->now).normalized());
  }
}

void CurveEditor::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) {
    drag_ = Pan{event->position()};
  } else if (event->button() == Qt::LeftButton && !curves_.empty()) {
    mouse_.press(event->position());
    press_left(event->position(), event->modifiers() & Qt::ShiftModifier);
  }
  update();
}

void CurveEditor::press_left(const QPointF& at, bool adds) {
  const std::optional<CurveMark> mark = mark_near(curves_, axes_, at);
  if (mark) {
    press_key(*mark, at, adds);
    return;
  }
  if (const auto handle = handle_near(handles(), at)) {
    drag_ = TangentDrag{scene_part(document_.scene(), row_->part), handle->mark,
                        value_of(handle->mark), handle->side, new_merge_id()};
    return;
  }
  constexpr double playhead_width = 4.0;  // pixels, to either side
  const double playhead = position(timeline_.time(), 0.0).x();
  if (axes_.is_on_ruler(at) || (!adds && std::abs(at.x() - playhead) < playhead_width)) {
    drag_ = Scrub{};
    timeline_.set_frame(frame_near(at.x()));
    return;
  }
  if (!adds) selection_.set({});
  drag_ = RectangleDrag{at, at, selection_.marks()};
}

void CurveEditor::press_key(const CurveMark& mark, const QPointF& at, bool adds) {
  if (adds) {
    selection_.toggle(mark);
    return;
  }
  if (!selection_.contains(mark)) selection_.set({mark});
  KeysDrag keys{.before = scene_part(document_.scene(), row_->part),
                .marks = selection_.marks(),
                .values = {},
                .grabbed = mark,
                .press = at,
                .gesture = new_merge_id()};
  for (const CurveMark& selected : keys.marks) keys.values.push_back(value_of(selected));
  drag_ = std::move(keys);
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
  const QPointF mouse_position = event->position();
  if (auto* pan = std::get_if<Pan>(&drag_)) {
    axes_.pan(mouse_position - pan->last);
    pan->last = mouse_position;
  } else if (std::holds_alternative<Scrub>(drag_)) {
    timeline_.set_frame(frame_near(mouse_position.x()));
  } else if (!mouse_.has_begun(mouse_position)) {
    return;
  } else if (auto* keys = std::get_if<KeysDrag>(&drag_)) {
    drag_keys(*keys, mouse_position);
  } else if (const auto* tangent = std::get_if<TangentDrag>(&drag_)) {
    drag_tangent(*tangent, mouse_position, event->modifiers() & Qt::AltModifier);
  } else if (auto* rectangle = std::get_if<RectangleDrag>(&drag_)) {
    drag_rectangle(*rectangle, mouse_position);
  }
  update();
}

void CurveEditor::drag_keys(KeysDrag& drag, const QPointF& to) {
  const QPointF moved = to - drag.press;
  const double grabbed_time = drag.grabbed.time;
  // A key between two frames stays there until it is moved.
  const double frames = std::round(timeline_.frame_of(moved.x() * axes_.time_per_pixel()));
  const double frame = std::round(timeline_.frame_of(grabbed_time) + frames);
  double shift = frames == 0.0 ? 0.0 : timeline_.time_of(frame) - grabbed_time;
  for (const CurveMark& mark : drag.marks) shift = std::max(shift, std::min(0.0, -mark.time));
  std::vector<CurveKeyMove> moves;
  std::vector<CurveMark> now;
  for (std::size_t i = 0; i < drag.marks.size(); ++i) {
    const auto [curve, time] = drag.marks[i];
    const double value = drag.values[i] - moved.y() * axes_.value_per_pixel();
    const double moved_time = shift == 0.0 ? time : on_frame(time + shift);
    moves.push_back({curves_[curve], {time, moved_time}, value});
    now.push_back({curve, moved_time});
  }
  selection_.set(now);
  move_curve_keys(document_, *row_, drag.before, moves, drag.gesture);
}

// The tangent points at the mouse, which stays on its side of the key.
void CurveEditor::drag_tangent(const TangentDrag& drag, const QPointF& to, bool alone) {
  const double sign = drag.side == TangentSide::out ? 1.0 : -1.0;
  const double min_distance = axes_.time_per_pixel();
  const double distance = std::max(min_distance, sign * (axes_.time_at(to.x()) - drag.mark.time));
  const double slope = sign * (axes_.value_at(to.y()) - drag.value) / distance;
  set_tangent(document_, *row_, curves_[drag.mark.curve], {drag.mark.time, drag.side, slope, alone},
              drag.gesture);
}

void CurveEditor::drag_rectangle(RectangleDrag& drag, const QPointF& to) {
  drag.now = to;
  const QRectF area = QRectF(drag.press, to).normalized();
  selection_.set(drag.kept);
  for (const CurveMark& mark : all_marks(curves_)) {
    if (area.contains(position(mark.time, value_of(mark)))) selection_.add(mark);
  }
}

void CurveEditor::mouseReleaseEvent(QMouseEvent* event) {
  // A click on one of several selected keys selects it alone.
  if (const auto* keys = std::get_if<KeysDrag>(&drag_);
      keys && !mouse_.has_begun(event->position())) {
    selection_.set({keys->grabbed});
  }
  mouse_.release();
  drag_ = {};
  update();
}

void CurveEditor::cancel_drag() {
  if (const auto* keys = std::get_if<KeysDrag>(&drag_)) {
    selection_.set(keys->marks);
    set_scene_part(document_, keys->before, {}, keys->gesture);
  } else if (const auto* tangent = std::get_if<TangentDrag>(&drag_)) {
    set_scene_part(document_, tangent->before, {}, tangent->gesture);
  } else if (const auto* rectangle = std::get_if<RectangleDrag>(&drag_)) {
    selection_.set(rectangle->kept);
  }
  drag_ = {};
  update();
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || curves_.empty()) return;
  const auto mark = mark_near(curves_, axes_, event->position());
  const int frame = mark ? static_cast<int>(std::round(timeline_.frame_of(mark->time)))
                         : frame_near(event->position().x());
  timeline_.set_frame(frame);
  if (!mark) set_keys(document_, *row_);
}

void CurveEditor::wheelEvent(QWheelEvent* event) {
  // Qt turns the wheel sideways with some keys.
  const QPoint angle = event->angleDelta();
  const double factor = std::pow(0.999, angle.y() != 0 ? angle.y() : angle.x());
  axes_.zoom(event->position(), event->modifiers() & Qt::ControlModifier ? 1.0 : factor,
             event->modifiers() & Qt::ShiftModifier ? 1.0 : factor);
  update();
  event->accept();
}

void CurveEditor::contextMenuEvent(QContextMenuEvent* event) {
  const auto mark = mark_near(curves_, axes_, event->pos());
  if (!mark) return;
  if (!selection_.contains(*mark)) selection_.set({*mark});
  update();
  std::vector<double> times = selection_.times();
  // The menu says how the key below the mouse is.
  std::ranges::rotate(times, std::ranges::find_if(times, [&mark](double time) {
                        return std::abs(time - mark->time) < min_key_distance;
                      }));
  const double value = value_of(*mark);
  std::vector<KeyAction> actions{
      {tr("Align to &Playhead"), [this] { align_keys(document_, *row_, selection_.times()); }}};
  if (selection_.marks().size() > 1) {
    actions.push_back({tr("Same &Value"), [this, value] { level(value); }});
  }
  actions.push_back({tr("&Delete"), [this] { delete_selected(); }});
  show_key_menu(*this, document_, *row_, times, actions, event->globalPos());
}

void CurveEditor::level(double value) {
  std::vector<CurveKeyMove> moves;
  for (const CurveMark& mark : selection_.marks()) {
    moves.push_back({curves_[mark.curve], {mark.time, mark.time}, value});
  }
  move_curve_keys(document_, *row_, scene_part(document_.scene(), row_->part), moves, no_merge);
}

void CurveEditor::delete_selected() {
  const std::vector<double> times = selection_.times();
  selection_.set({});
  drag_ = {};
  if (row_ && !times.empty()) delete_keys(document_, *row_, times);
}

// Delete, Home and Ctrl+A are shortcuts of the window too.
bool CurveEditor::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if ((is_key_of("edit.delete", *key) && !selection_.empty()) ||
        (key->key() == Qt::Key_Home && key->modifiers() == Qt::NoModifier) ||
        key->matches(QKeySequence::SelectAll)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void CurveEditor::keyPressEvent(QKeyEvent* event) {
  if (is_key_of("edit.delete", *event) && !selection_.empty()) {
    delete_selected();
  } else if (event->key() == Qt::Key_Home && event->modifiers() == Qt::NoModifier) {
    fit();
  } else if (event->matches(QKeySequence::SelectAll)) {
    selection_.set(all_marks(curves_));
    update();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace brume
