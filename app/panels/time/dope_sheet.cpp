#include "app/panels/time/dope_sheet.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/document/document.h"
#include "app/document/time/timeline.h"
#include "app/panels/time/key_menu.h"
#include "app/widgets/application.h"
#include "app/widgets/keys.h"

namespace brume {
namespace {

constexpr int row_height = 18;
constexpr int fold_width = 18;  // of the triangle before an object's name
constexpr double mark_radius = 5.0;

// The place of an object that went.
constexpr std::size_t no_place = std::numeric_limits<std::size_t>::max();

double first_time(const std::vector<TrackKeys>& keys) {
  double first = std::numeric_limits<double>::infinity();
  for (const TrackKeys& track : keys) first = std::min(first, std::ranges::min(track.times));
  return first;
}

// Whether two rows are of the same values, at the same places of their parts.
bool has_same_tracks(const DopeRow& a, const DopeRow& b) {
  return a.is_object == b.is_object &&
         std::ranges::equal(a.tracks, b.tracks, [](const Track& track, const Track& other) {
           return track == other && track.first == other.first && track.count == other.count;
         });
}

}  // namespace

DopeSheet::DopeSheet(Timeline& timeline, Document& document, QWidget* parent)
    : QWidget(parent), timeline_(timeline), document_(document) {
  setFocusPolicy(Qt::ClickFocus);
  setAccessibleName(tr("Dope sheet"));
  setToolTip(
      tr("Drag keyframes to other frames; Shift or a rectangle selects several. Del to delete, "
         "Ctrl+C and Ctrl+V to copy, right-click for options, double-click to add one. Names are "
         "chosen for the curves and for I. Ctrl and the wheel zoom, the middle button pans, Home "
         "fits."));
  on_change(document_, Change::scene, this, [this] {
    drag_ = {};
    selection_.set({});
    copied_.reset();
    folded_.clear();
    choose({});
    refresh();
  });
  connect(&document_, &Document::changed, this, [this](const DocumentChange& change) {
    if (!(change.what & (Change::part | Change::groups))) return;
    if (change.what & Change::time) return update();
    const std::size_t chosen_count = chosen_.size();
    if (change.places) follow(*change.places);
    const bool is_chosen_fewer = chosen_.size() < chosen_count;
    refresh();
    if (is_chosen_fewer) Q_EMIT chosen_changed();
  });
  connect(&timeline_, &Timeline::changed, this, qOverload<>(&QWidget::update));
  connect(&mouse_, &MouseDrag::cancelled, this, &DopeSheet::cancel_drag);
  connect(&mouse_, &MouseDrag::ended, this, [this] { drag_ = {}; });
  refresh();
}

void DopeSheet::refresh() {
  const std::vector<KeyedTrack> keyed = keyed_tracks(document_.scene());
  std::vector<DopeRow> rows = dope_rows(document_.scene(), keyed, filter_, folded_);
  if (!std::ranges::equal(rows, rows_, has_same_tracks)) drag_ = {};
  rows_ = std::move(rows);
  selection_.prune(keyed);
  std::vector<Track> chosen;
  for (const Track& track : chosen_) {
    const auto found = std::ranges::find(keyed, track, &KeyedTrack::track);
    if (found != keyed.end()) chosen.push_back(found->track);
  }
  choose(std::move(chosen));
  setMinimumHeight(static_cast<int>(rows_.size()) * row_height + 4);
  update();
}

void DopeSheet::follow(const ObjectPlaces& places) {
  drag_ = {};
  selection_.follow(places);
  follow_places(chosen_, places);
  if (copied_) {
    // Copies of an object's keys stay when it went, to be pasted elsewhere.
    for (auto& [track, times] : copied_->keys) {
      if (track.part == places.part) track.place = places.of(track.place).value_or(no_place);
    }
  }
  std::set<DopeObject> folded;
  for (DopeObject object : folded_) {
    if (object.part == places.part) {
      const auto place = places.of(object.place);
      if (!place) continue;
      object.place = *place;
    }
    folded.insert(object);
  }
  folded_ = std::move(folded);
}

void DopeSheet::set_filter(const QString& filter) {
  filter_ = filter;
  refresh();
}

void DopeSheet::fit() {
  double last = 0.0;
  for (const DopeRow& row : rows_) {
    if (!row.keys.empty()) last = std::max(last, row.keys.back().time);
  }
  fit_frames(timeline_, last);
}

FrameScale DopeSheet::scale() const {
  return {timeline_, names_width, static_cast<double>(width() - names_width)};
}

int DopeSheet::frame_near(double x) const {
  return static_cast<int>(std::max(0.0, std::round(scale().frame_at(x))));
}

QPoint DopeSheet::position(std::size_t row, int frame) const {
  return {static_cast<int>(std::round(scale().x_of(frame))), name_position(row).y()};
}

QPoint DopeSheet::name_position(std::size_t row) const {
  return {names_width / 2, static_cast<int>(row) * row_height + row_height / 2 + 2};
}

std::optional<std::size_t> DopeSheet::row_at(double y) const {
  const double row = std::floor((y - 2.0) / row_height);
  if (row < 0.0 || row >= static_cast<double>(rows_.size())) return std::nullopt;
  return static_cast<std::size_t>(row);
}

std::optional<DopeSheet::Mark> DopeSheet::mark_at(QPointF position) const {
  const auto row = row_at(position.y());
  if (!row || position.x() < names_width || rows_[*row].is_fixed()) return std::nullopt;
  const FrameScale shown = scale();
  std::optional<Mark> nearest;
  double min_distance = mark_radius + 2.0;
  for (const Keyframe& key : rows_[*row].keys) {
    const double distance = std::abs(shown.x_of(timeline_.frame_of(key.time)) - position.x());
    if (distance > min_distance || !rows_[*row].has_own_key(key.time)) continue;
    min_distance = distance;
    nearest = Mark{*row, key.time};
  }
  return nearest;
}

void DopeSheet::choose(std::vector<Track> tracks) {
  const bool is_same = tracks == chosen_;
  chosen_ = std::move(tracks);  // they may be elsewhere in their part
  if (is_same) return;
  update();
  Q_EMIT chosen_changed();
}

void DopeSheet::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const auto first = static_cast<std::size_t>(std::max(0, event->rect().top() / row_height - 1));
  const auto end =
      std::min(rows_.size(), static_cast<std::size_t>(event->rect().bottom() / row_height + 1));
  for (std::size_t k = first; k < end; ++k) paint_row(painter, k);
  painter.setClipRect(QRect(names_width, 0, width() - names_width, height()));
  scale().paint_lines(painter, *this);
  for (std::size_t k = first; k < end; ++k) paint_keys(painter, k);
  painter.setClipping(false);
  if (rows_.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(
        rect().adjusted(12, 4, -12, -4), Qt::AlignCenter | Qt::TextWordWrap,
        filter_.trimmed().isEmpty()
            ? tr("Nothing is animated yet. The diamond beside a value sets its first keyframe; so "
                 "does K with the mouse over it.")
            : tr("No animated value has \"%1\" in its name.").arg(filter_.trimmed()));
  }
  if (const auto* drawn = std::get_if<RectangleDrag>(&drag_)) {
    paint_rubber_band(painter, QRectF(drawn->press, drawn->now));
  }
}

void DopeSheet::paint_row(QPainter& painter, std::size_t k) const {
  const DopeRow& row = rows_[k];
  const int top = static_cast<int>(k) * row_height + 2;
  if (row.is_object) {
    painter.fillRect(0, top, width(), row_height, palette().color(QPalette::Button));
  }
  const bool is_chosen =
      !row.is_object && std::ranges::find(chosen_, row.tracks.front()) != chosen_.end();
  if (is_chosen) {
    painter.fillRect(0, top, names_width, row_height, palette().color(QPalette::Highlight));
  }
  painter.setPen(palette().color(is_chosen ? QPalette::HighlightedText : QPalette::Text));
  const QRect title(fold_width + (row.is_object ? 0 : 14), top,
                    names_width - fold_width - (row.is_object ? 4 : 18), row_height);
  painter.drawText(title, Qt::AlignVCenter,
                   fontMetrics().elidedText(row.text, Qt::ElideRight, title.width()));
  if (!row.is_object) return;
  const QRect fold(0, top, fold_width, row_height);
  painter.drawText(fold, Qt::AlignCenter,
                   folded_.contains(row.object) ? QStringLiteral("▸") : QStringLiteral("▾"));
}

void DopeSheet::paint_keys(QPainter& painter, std::size_t k) const {
  const DopeRow& row = rows_[k];
  const FrameScale shown = scale();
  const QColor text = palette().color(row.is_fixed() ? QPalette::PlaceholderText : QPalette::Text);
  for (const Keyframe& key : row.keys) {
    const double x = shown.x_of(timeline_.frame_of(key.time));
    if (x < names_width - mark_radius || x > width() + mark_radius) continue;
    const bool is_selected = row.has_own_key(key.time) && selection_.contains(row, key.time);
    painter.setPen(QPen(is_selected ? Qt::white : palette().color(QPalette::Base), 1.0));
    painter.setBrush(is_selected ? accent_color() : text);
    painter.drawConvexPolygon(key_shape(key.interpolation,
                                        {x, static_cast<double>(name_position(k).y())},
                                        row.is_object ? mark_radius - 1.0 : mark_radius));
  }
}

void DopeSheet::mousePressEvent(QMouseEvent* event) {
  const QPointF press = event->position();
  if (event->button() == Qt::MiddleButton) drag_ = Pan{press.x()};
  if (event->button() != Qt::LeftButton) return;
  const auto row = row_at(press.y());
  if (press.x() < names_width) {
    if (row) press_name(*row, *event);
    return;
  }
  mouse_.press(press);
  if (const auto mark = mark_at(press)) {
    press_key(*mark, *event);
  } else {
    if (!(event->modifiers() & Qt::ShiftModifier)) selection_.set({});
    drag_ = RectangleDrag{press, press, selection_};
  }
  update();
}

// An object stands for all its values.
void DopeSheet::press_name(std::size_t row, const QMouseEvent& event) {
  const DopeRow& pressed = rows_[row];
  if (pressed.is_object && event.position().x() < fold_width) {
    if (folded_.erase(pressed.object) == 0) folded_.insert(pressed.object);
    return refresh();
  }
  std::vector<Track> tracks = pressed.tracks;
  std::erase_if(tracks, [](const Track& track) { return track.count == 0; });
  if (!(event.modifiers() & (Qt::ControlModifier | Qt::ShiftModifier))) return choose(tracks);
  std::vector<Track> chosen = chosen_;
  const bool is_chosen = std::ranges::all_of(tracks, [&chosen](const Track& track) {
    return std::ranges::find(chosen, track) != chosen.end();
  });
  std::erase_if(chosen, [&tracks](const Track& track) {
    return std::ranges::find(tracks, track) != tracks.end();
  });
  if (!is_chosen) chosen.insert(chosen.end(), tracks.begin(), tracks.end());
  choose(std::move(chosen));
}

void DopeSheet::press_key(const Mark& mark, const QMouseEvent& event) {
  const DopeRow& row = rows_[mark.row];
  const bool is_selected = selection_.contains(row, mark.time);
  if (event.modifiers() & Qt::ShiftModifier) {
    is_selected ? selection_.remove(row, mark.time) : selection_.add(row, mark.time);
    return;
  }
  if (!is_selected) {
    selection_.set({});
    selection_.add(row, mark.time);
  }
  drag_ = KeysDrag{.parts_at_start = parts_of(document_.scene(), selection_.keys()),
                   .keys = selection_.keys(),
                   .grabbed = mark,
                   .press = event.position(),
                   .frames_per_pixel = scale().frames_per_pixel(),
                   .gesture = new_merge_id()};
}

void DopeSheet::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = event->position();
  if (auto* pan = std::get_if<Pan>(&drag_)) {
    pan_frames(timeline_, scale(), position.x() - pan->last_x);
    pan->last_x = position.x();
  } else if (!mouse_.has_begun(position)) {
    return;
  } else if (auto* keys = std::get_if<KeysDrag>(&drag_)) {
    drag_keys(*keys, position);
  } else if (auto* rectangle = std::get_if<RectangleDrag>(&drag_)) {
    drag_rectangle(*rectangle, position);
  }
  update();
}

void DopeSheet::drag_keys(KeysDrag& drag, const QPointF& to) {
  const double shift =
      snapped_shift(timeline_, drag.grabbed.time, (to.x() - drag.press.x()) * drag.frames_per_pixel,
                    first_time(drag.keys));
  std::vector<TrackMoves> moves;
  std::vector<TrackKeys> moved;
  for (const TrackKeys& keys : drag.keys) {
    moves.push_back({keys.track, {}});
    moved.push_back({keys.track, {}});
    for (const double time : keys.times) {
      const double moved_time = shift == 0.0 ? time : on_frame(timeline_, time + shift);
      moves.back().moves.push_back({time, moved_time});
      moved.back().times.push_back(moved_time);
    }
  }
  drag.has_moved = true;
  move_keys(document_, drag.parts_at_start, moves, drag.gesture);
  selection_.set(std::move(moved));
}

void DopeSheet::drag_rectangle(RectangleDrag& drag, const QPointF& to) {
  drag.now = to;
  const QRectF area = QRectF(drag.press, to).normalized();
  const FrameScale shown = scale();
  selection_ = drag.kept;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const double y = name_position(k).y();
    if (y < area.top() || y > area.bottom()) continue;
    for (const Keyframe& key : rows_[k].keys) {
      const double x = shown.x_of(timeline_.frame_of(key.time));
      if (x >= area.left() && x <= area.right()) selection_.add(rows_[k], key.time);
    }
  }
}

void DopeSheet::mouseReleaseEvent(QMouseEvent* event) {
  // A click on one of several selected keys selects it alone.
  if (const auto* keys = std::get_if<KeysDrag>(&drag_);
      keys && !mouse_.has_begun(event->position())) {
    const Mark mark = keys->grabbed;
    selection_.set({});
    selection_.add(rows_[mark.row], mark.time);
  }
  mouse_.release();
  drag_ = {};
  update();
}

void DopeSheet::cancel_drag() {
  if (const auto* keys = std::get_if<KeysDrag>(&drag_)) {
    const KeysDrag drag = *keys;
    if (drag.has_moved) restore_parts(document_, drag.parts_at_start, drag.gesture);
    selection_.set(drag.keys);
  } else if (const auto* rectangle = std::get_if<RectangleDrag>(&drag_)) {
    selection_ = rectangle->kept;
  }
  drag_ = {};
  update();
}

void DopeSheet::mouseDoubleClickEvent(QMouseEvent* event) {
  const auto row = row_at(event->position().y());
  if (event->button() != Qt::LeftButton || !row) return;
  if (event->position().x() < names_width) {
    if (!chosen_.empty()) Q_EMIT curves_asked_for();
    return;
  }
  const std::optional<Mark> mark = mark_at(event->position());
  drag_ = {};
  timeline_.set_frame(mark ? static_cast<int>(std::round(timeline_.frame_of(mark->time)))
                           : frame_near(event->position().x()));
  if (!mark && !rows_[*row].is_object && !rows_[*row].is_fixed()) {
    const std::vector<Track> tracks = rows_[*row].tracks;
    set_keys(document_, tracks);
  }
}

void DopeSheet::contextMenuEvent(QContextMenuEvent* event) {
  const auto mark = mark_at(event->pos());
  if (!mark) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("&Paste"), this, &DopeSheet::paste)->setEnabled(copied_.has_value());
    menu->addAction(tr("Select &All"), this, &DopeSheet::select_all);
    menu->addAction(tr("Show &Curves"), this, &DopeSheet::curves_asked_for);
    menu->addAction(tr("&Fit"), this, &DopeSheet::fit);
    return menu->popup(event->globalPos());
  }
  const DopeRow& row = rows_[mark->row];
  if (!selection_.contains(row, mark->time)) {
    selection_.set({});
    selection_.add(row, mark->time);
  }
  update();
  // The menu says how the key below the mouse is.
  std::size_t k = 0;
  while (k + 1 < row.tracks.size() && !selection_.contains(row.tracks[k], mark->time)) ++k;
  show_key_menu(*this, document_, selection_.keys(), row.tracks[k], mark->time,
                {{tr("Align to &Playhead"), [this] { align_keys(document_, selection_.keys()); }},
                 {tr("&Copy"), [this] { copy_selected(); }},
                 {tr("&Delete"), [this] { delete_selected(); }}},
                event->globalPos());
}

void DopeSheet::select_all() {
  selection_.set({});
  for (const DopeRow& row : rows_) {
    for (const Keyframe& key : row.keys) selection_.add(row, key.time);
  }
  update();
}

void DopeSheet::delete_selected() {
  const std::vector<TrackKeys> keys = selection_.keys();
  selection_.set({});
  drag_ = {};
  delete_keys(document_, keys);
}

void DopeSheet::copy_selected() {
  copied_ = copy_keys(document_.scene(), selection_.keys());
}

void DopeSheet::paste() {
  if (!copied_) return;
  std::vector<TrackKeys> pasted = paste_keys(document_, *copied_, chosen_);
  selection_.set(std::move(pasted));
  selection_.prune(keyed_tracks(document_.scene()));
  update();
}

bool DopeSheet::acts_on(const QKeyEvent& key) const {
  const bool is_about_selected = is_key_of("edit.delete", key) || is_key_of("edit.copy", key);
  return (is_about_selected && !selection_.empty()) || is_key_of("edit.paste", key) ||
         is_key_of("select.all", key) ||
         (key.key() == Qt::Key_Home && key.modifiers() == Qt::NoModifier);
}

// These keys are shortcuts of the window too, for Gaussians; so are letters, but that which sets a
// keyframe, and Delete where no key is selected.
bool DopeSheet::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = *static_cast<const QKeyEvent*>(event);
    const bool is_other_letter = is_letter(key) && !is_key_of("time.set_key", key);
    if (acts_on(key) || is_other_letter || is_key_of("edit.delete", key)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void DopeSheet::keyPressEvent(QKeyEvent* event) {
  if (!acts_on(*event)) return QWidget::keyPressEvent(event);
  if (is_key_of("edit.delete", *event)) return delete_selected();
  if (is_key_of("edit.copy", *event)) return copy_selected();
  if (is_key_of("edit.paste", *event)) return paste();
  if (is_key_of("select.all", *event)) return select_all();
  fit();
}

// Without Ctrl the wheel scrolls the rows.
void DopeSheet::wheelEvent(QWheelEvent* event) {
  if (!(event->modifiers() & Qt::ControlModifier)) return event->ignore();
  zoom_frames(timeline_, scale(), event->position().x(), std::pow(0.999, event->angleDelta().y()));
  event->accept();
}

}  // namespace brume
