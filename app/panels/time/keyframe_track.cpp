#include "app/panels/time/keyframe_track.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/commands/edit_keys.h"
#include "app/document/document.h"
#include "app/document/timeline.h"
#include "app/panels/time/key_menu.h"
#include "app/widgets/application.h"
#include "app/widgets/keys.h"

namespace brume {
namespace {

constexpr int row_height = 18;
constexpr int margin = 10;
constexpr double mark_radius = 5.0;

}  // namespace

KeyframeTrack::KeyframeTrack(Timeline& timeline, Document& document, QWidget* parent)
    : QWidget(parent), timeline_(timeline), document_(document) {
  setFocusPolicy(Qt::ClickFocus);
  setToolTip(tr(
      "Keyframes: drag to move, Del to delete, right-click for options, double-click to add one"));
  on_change(document_, Change::scene, this, [this] {
    drag_.reset();
    chosen_.reset();
    refresh();
  });
  on_change(document_, Change::part, this, &KeyframeTrack::refresh);
  connect(&timeline_, &Timeline::changed, this, qOverload<>(&QWidget::update));
  connect(&mouse_, &MouseDrag::cancelled, this, [this] {
    if (drag_) drag_to(drag_->from);
    drag_.reset();
  });
  connect(&mouse_, &MouseDrag::ended, this, [this] { drag_.reset(); });
  refresh();
}

void KeyframeTrack::refresh() {
  rows_ = tracks_with_keys(document_.scene());
  for (const Track& row : imported_tracks(document_.scene())) rows_.push_back(row);
  marks_.clear();
  for (const Track& row : rows_) marks_.push_back(keyframes_of(document_.scene(), row));
  if (chosen_ && chosen_->row >= rows_.size()) chosen_.reset();
  setVisible(!rows_.empty());
  updateGeometry();
  setFixedHeight(KeyframeTrack::sizeHint().height());
  update();
}

QSize KeyframeTrack::sizeHint() const {
  return {400, std::max(1, static_cast<int>(rows_.size())) * row_height + 4};
}

void KeyframeTrack::set_ends(double first_x, double last_x) {
  if (first_x == first_x_ && last_x == last_x_) return;
  first_x_ = first_x;
  last_x_ = last_x;
  update();
}

double KeyframeTrack::x_of(double frame) const {
  const double length = std::max(1, timeline_.last() - timeline_.first());
  return first_x_ + (last_x_ - first_x_) * (frame - timeline_.first()) / length;
}

int KeyframeTrack::frame_at(double x) const {
  const double length = std::max(1, timeline_.last() - timeline_.first());
  const double room = std::max(1.0, last_x_ - first_x_);
  const double frame = timeline_.first() + std::round((x - first_x_) / room * length);
  return static_cast<int>(std::clamp<double>(frame, timeline_.first(), timeline_.last()));
}

QPoint KeyframeTrack::position(std::size_t row, int frame) const {
  return {static_cast<int>(std::round(x_of(frame))),
          static_cast<int>(row) * row_height + row_height / 2 + 2};
}

std::optional<KeyframeTrack::Mark> KeyframeTrack::mark_at(QPointF position) const {
  const double row = std::floor((position.y() - 2) / row_height);
  if (row < 0 || row >= static_cast<double>(rows_.size())) return std::nullopt;
  const auto k = static_cast<std::size_t>(row);
  if (rows_[k].count == 0) return std::nullopt;
  std::optional<Mark> nearest;
  double min_value = mark_radius + 2.0;
  for (const Keyframe& mark : marks_[k]) {
    const double distance = std::abs(x_of(timeline_.frame_of(mark.time)) - position.x());
    if (distance > min_value) continue;
    min_value = distance;
    nearest = Mark{k, mark.time};
  }
  return nearest;
}

bool KeyframeTrack::is_chosen(std::size_t row, double time) const {
  return chosen_ && chosen_->row == row && std::abs(chosen_->time - time) < min_key_distance;
}

void KeyframeTrack::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor text = palette().color(QPalette::Text);
  const QColor faint = palette().color(QPalette::PlaceholderText);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const int top = static_cast<int>(k) * row_height + 2;
    if (k % 2 == 0) {
      painter.fillRect(0, top, width(), row_height, palette().color(QPalette::AlternateBase));
    }
    painter.setPen(text);
    const QRect title(margin, top, static_cast<int>(first_x_) - 2 * margin, row_height);
    painter.drawText(title, Qt::AlignVCenter,
                     fontMetrics().elidedText(rows_[k].title, Qt::ElideRight, title.width()));
  }
  painter.setPen(QPen(accent_color(), 1.5));
  const double now = x_of(timeline_.frame());
  painter.drawLine(QPointF(now, 0), QPointF(now, height()));
  painter.setClipRect(QRectF(first_x_ - margin, 0, width(), height()));
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    for (const Keyframe& mark : marks_[k]) {
      const double x = x_of(timeline_.frame_of(mark.time));
      const double y = position(k, 0).y();
      const bool chosen = is_chosen(k, mark.time);
      painter.setPen(QPen(chosen ? Qt::white : palette().color(QPalette::Base), 1.0));
      painter.setBrush(chosen ? accent_color() : rows_[k].count > 0 ? text : faint);
      painter.drawConvexPolygon(key_shape(mark.interpolation, {x, y}, mark_radius));
    }
  }
}

void KeyframeTrack::mousePressEvent(QMouseEvent* event) {
  chosen_ = mark_at(event->position());
  if (event->button() == Qt::LeftButton) {
    if (chosen_) {
      drag_ = Drag{scene_part(document_.scene(), rows_[chosen_->row].part), chosen_->time,
                   chosen_->time, new_merge_id()};
      mouse_.press(event->position());
    } else if (event->position().x() > first_x_ - margin) {
      scrubs_ = true;
      timeline_.set_frame(frame_at(event->position().x()));
    }
  }
  update();
}

void KeyframeTrack::mouseMoveEvent(QMouseEvent* event) {
  const int frame = frame_at(event->position().x());
  if (scrubs_) timeline_.set_frame(frame);
  if (!drag_ || !mouse_.has_begun(event->position())) return;
  // A key between two frames stays there until it is moved.
  const bool is_back = frame == frame_at(x_of(timeline_.frame_of(drag_->from)));
  drag_to(is_back ? drag_->from : timeline_.time_of(frame));
}

void KeyframeTrack::drag_to(double time) {
  if (!chosen_ || time == drag_->to) return;
  drag_->to = time;
  chosen_->time = time;
  const KeyMove move{drag_->from, time};
  move_keys(document_, rows_[chosen_->row], drag_->before, {&move, 1}, drag_->gesture);
}

void KeyframeTrack::mouseReleaseEvent(QMouseEvent*) {
  mouse_.release();
  drag_.reset();
  scrubs_ = false;
}

void KeyframeTrack::mouseDoubleClickEvent(QMouseEvent* event) {
  const double row = std::floor((event->position().y() - 2) / row_height);
  if (event->button() != Qt::LeftButton || event->position().x() <= first_x_ - margin) return;
  if (row < 0 || row >= static_cast<double>(rows_.size())) return;
  const std::optional<Mark> mark = mark_at(event->position());
  const double time = mark ? mark->time : timeline_.time_of(frame_at(event->position().x()));
  timeline_.set_frame(static_cast<int>(std::round(timeline_.frame_of(time))));
  const Track& track = rows_[static_cast<std::size_t>(row)];
  if (!mark && track.count > 0) set_keys(document_, track);
}

void KeyframeTrack::contextMenuEvent(QContextMenuEvent* event) {
  chosen_ = mark_at(event->pos());
  update();
  if (!chosen_) return;
  const Track& row = rows_[chosen_->row];
  const std::vector<double> times{chosen_->time};
  show_key_menu(
      *this, document_, row, times,
      {{tr("Align to &Playhead"), [this, row, times] { align_keys(document_, row, times); }},
       {tr("&Delete"), [this] { delete_chosen(); }}},
      event->globalPos());
}

void KeyframeTrack::delete_chosen() {
  if (!chosen_) return;
  const Mark mark = *chosen_;
  chosen_.reset();
  drag_.reset();
  delete_keys(document_, rows_[mark.row], {&mark.time, 1});
}

// The keys of Delete are shortcuts of the window too, for Gaussians.
bool KeyframeTrack::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && chosen_ &&
      is_key_of("edit.delete", *static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void KeyframeTrack::keyPressEvent(QKeyEvent* event) {
  if (chosen_ && is_key_of("edit.delete", *event)) {
    delete_chosen();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace brume
