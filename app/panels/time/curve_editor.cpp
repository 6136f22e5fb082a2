#include "app/panels/time/curve_editor.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/commands/objects/edit_keys.h"
#include "app/document/document.h"
#include "app/document/time/timeline.h"
#include "app/panels/time/key_menu.h"
#include "app/widgets/application.h"
#include "app/widgets/keys.h"

namespace brume {
namespace {

constexpr double point_radius = 4.0;   // pixels
constexpr double handle_radius = 3.0;  // pixels

}  // namespace

CurveEditor::CurveEditor(Timeline& timeline, Document& document, QWidget* parent)
    : QWidget(parent), timeline_(timeline), document_(document) {
  setFocusPolicy(Qt::ClickFocus);
  setToolTip(
      tr("Drag keys in time and value, and the ends of their tangents (Alt: one side alone). Shift "
         "or a rectangle selects several. Del to delete, right-click for options, double-click to "
         "add a key. Wheel to zoom (Shift: time only, Ctrl: "
         "value only), middle button to pan, Home to fit."));
  connect(&timeline_, &Timeline::changed, this, qOverload<>(&QWidget::update));
  connect(&mouse_, &MouseDrag::cancelled, this, &CurveEditor::cancel_drag);
  connect(&mouse_, &MouseDrag::ended, this, [this] { drag_ = {}; });
}

void CurveEditor::set_tracks(std::vector<Track> tracks, std::vector<Hidden> hidden) {
  tracks_ = std::move(tracks);
  hidden_ = std::move(hidden);
  active_ = 0;
  drag_ = {};
  selection_.set({});
  refresh();
  axes_.fit(curves_);
}

bool CurveEditor::is_hidden(const std::vector<Hidden>& hidden, const Track& track,
                            const CurveId& curve) {
  return std::ranges::find(hidden, to_hide(track, curve)) != hidden.end();
}

CurveEditor::Hidden CurveEditor::to_hide(const Track& track, const CurveId& curve) {
  return {track, {curve.value - track.first, curve.component}};
}

std::vector<CurveEditor::Hidden> CurveEditor::shown_numbers() const {
  std::vector<Hidden> numbers;
  for (const Curve& curve : curves_) numbers.push_back(to_hide(tracks_[curve.track], curve));
  return numbers;
}

void CurveEditor::update_tracks(std::vector<Track> tracks, std::vector<Hidden> hidden) {
  const bool is_elsewhere = !std::ranges::equal(tracks, tracks_, {}, &Track::first, &Track::first);
  const std::vector<Hidden> shown_before = shown_numbers();
  tracks_ = std::move(tracks);
  hidden_ = std::move(hidden);
  refresh();
  const bool are_others = shown_numbers() != shown_before;
  if (is_elsewhere || are_others) drag_ = {};
  if (are_others) selection_.set({});  // its marks count the curves
}

void CurveEditor::refresh() {
  curves_.clear();
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    for (Curve& curve : curves_of(document_.scene(), tracks_[k])) {
      if (is_hidden(hidden_, tracks_[k], curve)) continue;
      curve.track = k;
      curves_.push_back(std::move(curve));
    }
  }
  selection_.prune(curves_);
  update();
}

void CurveEditor::fit() {
  axes_.fit(curves_);
  double last = 0.0;
  for (const Curve& curve : curves_) last = std::max(last, curve.points().back().time);
  fit_frames(timeline_, last);
  update();
}

const Track& CurveEditor::track_of(const CurveMark& mark) const {
  return tracks_[curves_[mark.curve].track];
}

std::vector<TrackKeys> CurveEditor::selected_keys() const {
  return selection_.keys(curves_, tracks_);
}

// Red, green, blue as the axes, of a track alone; the hues of several tracks are their own.
QColor CurveEditor::color(std::size_t curve) const {
  static constexpr std::array axes{0xe0605a, 0x4fae57, 0x5b8def};
  static constexpr std::array tracks{0xe0a030, 0x9a7be0, 0x3fb5b0, 0xd06fa8, 0x8fae3c, 0x6f9bd0};
  const Curve& shown = curves_[curve];
  if (tracks_.size() < 2) {
    return QRgb(axes.at(static_cast<std::size_t>(shown.component)));
  }
  constexpr std::array brightness{100, 125, 155};
  return QColor(QRgb(tracks.at(shown.track % tracks.size())))
      .lighter(brightness.at(static_cast<std::size_t>(shown.component)));
}

// Further values of a track are dashed.
QPen CurveEditor::pen(std::size_t curve) const {
  QPen pen(color(curve), 1.6);
  const std::size_t of_track = curves_[curve].value - tracks_[curves_[curve].track].first;
  if (of_track == 1) pen.setStyle(Qt::DashLine);
  if (of_track == 2) pen.setStyle(Qt::DotLine);
  return pen;
}

void CurveEditor::resizeEvent(QResizeEvent*) {
  axes_.set_size(size());
}

double CurveEditor::value_of(const CurveMark& mark) const {
  return curves_[mark.curve].key_value(mark.time);
}

void CurveEditor::paint_curve(QPainter& painter, std::size_t k) const {
  const Curve& curve = curves_[k];
  QPainterPath path;
  constexpr int step = 2;  // pixels
  for (int x = 0; x <= width() + step; x += step) {
    const QPointF curve_point = position(axes_.time_at(x), curve.at(axes_.time_at(x)), curve.track);
    x == 0 ? path.moveTo(curve_point) : path.lineTo(curve_point);
  }
  const QPen line = pen(k);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(line);
  painter.drawPath(path);
  for (const Curve::Point& point : curve.points()) {
    const bool selected = selection_.contains({k, point.time});
    painter.setPen(QPen(palette().color(selected ? QPalette::Text : QPalette::Base), 1.5));
    painter.setBrush(line.color());
    painter.drawConvexPolygon(key_shape(point.interpolation,
                                        position(point.time, point.value, curve.track),
                                        selected ? point_radius + 1.5 : point_radius));
  }
}

void CurveEditor::paint_handles(QPainter& painter) const {
  for (const TangentHandle& handle : handles()) {
    const QColor line = color(handle.mark.curve);
    painter.setPen(QPen(line, 1.2, handle.is_automatic ? Qt::DotLine : Qt::SolidLine));
    painter.drawLine(handle.key, handle.tip);
    painter.setPen(QPen(line, 1.2));
    painter.setBrush(handle.is_automatic ? palette().color(QPalette::Base) : line);
    painter.drawEllipse(handle.tip, handle_radius, handle_radius);
  }
}

void CurveEditor::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (curves_.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(
        rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
        tr("No curve is shown. The diamond beside a value sets its first keyframe; the "
           "list at the left shows and hides the curves of values that have some."));
    return;
  }
  axes_.paint_values(painter, *this, active_);
  axes_.scale().paint_lines(painter, *this);
  paint_handles(painter);
  for (std::size_t k = 0; k < curves_.size(); ++k) paint_curve(painter, k);
  if (tracks_.size() > 1) {
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QPointF(60.0, fontMetrics().height()),
                     tr("Values of %1").arg(tracks_[active_].title()));
  }
  if (const auto* drawn = std::get_if<RectangleDrag>(&drag_)) {
    paint_rubber_band(painter, QRectF(drawn->press, drawn->now));
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

void CurveEditor::press_left(const QPointF& press, bool adds) {
  const std::optional<CurveMark> mark = mark_near(curves_, axes_, press);
  if (mark) {
    press_key(*mark, press, adds);
    return;
  }
  if (const auto handle = handle_near(handles(), press)) {
    drag_ = TangentDrag{parts_of(document_.scene(), selected_keys()), handle->mark,
                        value_of(handle->mark), handle->side, new_merge_id()};
    return;
  }
  constexpr double playhead_width = 4.0;  // pixels, to either side
  const double playhead = axes_.scale().x_of(timeline_.frame());
  if (!adds && std::abs(press.x() - playhead) < playhead_width) {
    drag_ = Scrub{};
    timeline_.set_frame(axes_.scale().scrub_frame(press.x()));
    return;
  }
  if (!adds) selection_.set({});
  drag_ = RectangleDrag{press, press, selection_.marks()};
}

void CurveEditor::press_key(const CurveMark& mark, const QPointF& press, bool adds) {
  active_ = curves_[mark.curve].track;
  if (adds) {
    selection_.toggle(mark);
    return;
  }
  if (!selection_.contains(mark)) selection_.set({mark});
  KeysDrag keys{.parts_at_start = parts_of(document_.scene(), selected_keys()),
                .marks = selection_.marks(),
                .values = {},
                .grabbed = mark,
                .press = press,
                .frames_per_pixel = axes_.scale().frames_per_pixel(),
                .gesture = new_merge_id()};
  for (const CurveMark& selected : keys.marks) keys.values.push_back(value_of(selected));
  drag_ = std::move(keys);
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
  const QPointF mouse_position = event->position();
  if (auto* pan = std::get_if<Pan>(&drag_)) {
    axes_.pan(mouse_position.y() - pan->last.y());
    pan_frames(timeline_, axes_.scale(), mouse_position.x() - pan->last.x());
    pan->last = mouse_position;
  } else if (std::holds_alternative<Scrub>(drag_)) {
    timeline_.set_frame(axes_.scale().scrub_frame(mouse_position.x()));
  } else if (!mouse_.has_begun(mouse_position)) {
    return;
  } else if (auto* keys = std::get_if<KeysDrag>(&drag_)) {
    drag_keys(*keys, mouse_position);
  } else if (auto* tangent = std::get_if<TangentDrag>(&drag_)) {
    drag_tangent(*tangent, mouse_position, event->modifiers() & Qt::AltModifier);
  } else if (auto* rectangle = std::get_if<RectangleDrag>(&drag_)) {
    drag_rectangle(*rectangle, mouse_position);
  }
  update();
}

void CurveEditor::drag_keys(KeysDrag& drag, const QPointF& to) {
  const QPointF moved = to - drag.press;
  const double shift =
      snapped_shift(timeline_, drag.grabbed.time, moved.x() * drag.frames_per_pixel,
                    std::ranges::min(drag.marks, {}, &CurveMark::time).time);
  std::vector<CurveKeyMove> moves;
  std::vector<CurveMark> now;
  for (std::size_t i = 0; i < drag.marks.size(); ++i) {
    const auto [curve, time] = drag.marks[i];
    const double value = drag.values[i] - moved.y() * axes_.value_per_pixel(curves_[curve].track);
    const double moved_time = shift == 0.0 ? time : on_frame(timeline_, time + shift);
    moves.push_back({tracks_[curves_[curve].track], curves_[curve], {time, moved_time}, value});
    now.push_back({curve, moved_time});
  }
  selection_.set(now);
  drag.has_moved = true;
  move_curve_keys(document_, drag.parts_at_start, moves, drag.gesture);
}

// The tangent points at the mouse, which stays on its side of the key.
void CurveEditor::drag_tangent(TangentDrag& drag, const QPointF& to, bool alone) {
  const double sign = drag.side == TangentSide::out ? 1.0 : -1.0;
  const double min_distance = axes_.time_per_pixel();
  const double distance = std::max(min_distance, sign * (axes_.time_at(to.x()) - drag.mark.time));
  const double value = axes_.value_at(to.y(), curves_[drag.mark.curve].track);
  const double slope = sign * (value - drag.key_value) / distance;
  drag.has_moved = true;
  set_tangent(document_, track_of(drag.mark), curves_[drag.mark.curve],
              {drag.mark.time, drag.side, slope, alone}, drag.gesture);
}

void CurveEditor::drag_rectangle(RectangleDrag& drag, const QPointF& to) {
  drag.now = to;
  const QRectF area = QRectF(drag.press, to).normalized();
  std::vector<CurveMark> marks = drag.kept;
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    for (const Curve::Point& point : curves_[k].points()) {
      if (area.contains(position(point.time, point.value, curves_[k].track))) {
        marks.push_back({k, point.time});
      }
    }
  }
  selection_.set(std::move(marks));
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
  // The edit that takes keys back looks at the drag, and may end it.
  const auto drag = std::exchange(drag_, {});
  if (const auto* keys = std::get_if<KeysDrag>(&drag)) {
    selection_.set(keys->marks);
    if (keys->has_moved) restore_parts(document_, keys->parts_at_start, keys->gesture);
  } else if (const auto* tangent = std::get_if<TangentDrag>(&drag)) {
    if (tangent->has_moved) restore_parts(document_, tangent->parts_at_start, tangent->gesture);
  } else if (const auto* rectangle = std::get_if<RectangleDrag>(&drag)) {
    selection_.set(rectangle->kept);
  }
  update();
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || curves_.empty()) return;
  const auto mark = mark_near(curves_, axes_, event->position());
  const int frame = mark ? static_cast<int>(std::round(timeline_.frame_of(mark->time)))
                         : axes_.scale().scrub_frame(event->position().x());
  timeline_.set_frame(frame);
  if (mark) return;
  active_ = curves_[curve_near(curves_, axes_, event->position())].track;
  set_keys(document_, tracks_[active_]);
}

void CurveEditor::wheelEvent(QWheelEvent* event) {
  // Qt turns the wheel sideways with some keys.
  const QPoint angle = event->angleDelta();
  const double factor = std::pow(0.999, angle.y() != 0 ? angle.y() : angle.x());
  if (!(event->modifiers() & Qt::ShiftModifier)) axes_.zoom(event->position().y(), factor);
  if (!(event->modifiers() & Qt::ControlModifier)) {
    zoom_frames(timeline_, axes_.scale(), event->position().x(), factor);
  }
  update();
  event->accept();
}

void CurveEditor::contextMenuEvent(QContextMenuEvent* event) {
  const auto mark = mark_near(curves_, axes_, event->pos());
  if (!mark) return;
  if (!selection_.contains(*mark)) selection_.set({*mark});
  update();
  const double value = value_of(*mark);
  std::vector<KeyAction> actions{
      {tr("Align to &Playhead"), [this] { align_keys(document_, selected_keys()); }}};
  if (selection_.marks().size() > 1) {
    actions.push_back({tr("Same &Value"), [this, value] { level(value); }});
  }
  actions.push_back({tr("&Delete"), [this] { delete_selected(); }});
  // The menu says how the key below the mouse is.
  show_key_menu(*this, document_, selected_keys(), track_of(*mark), mark->time, actions,
                event->globalPos());
}

void CurveEditor::level(double value) {
  std::vector<CurveKeyMove> moves;
  for (const CurveMark& mark : selection_.marks()) {
    moves.push_back({track_of(mark), curves_[mark.curve], {mark.time, mark.time}, value});
  }
  move_curve_keys(document_, parts_of(document_.scene(), selected_keys()), moves, no_merge);
}

void CurveEditor::delete_selected() {
  const std::vector<TrackKeys> keys = selected_keys();
  selection_.set({});
  drag_ = {};
  delete_keys(document_, keys);
}

// Letters, Delete, Home and Ctrl+A are shortcuts of the window too; the letter that sets a keyframe
// stays one.
bool CurveEditor::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool is_other_letter = is_letter(*key) && !is_key_of("time.set_key", *key);
    if (is_other_letter || is_key_of("edit.delete", *key) ||
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
