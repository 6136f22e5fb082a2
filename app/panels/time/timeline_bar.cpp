#include "app/panels/time/timeline_bar.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStyle>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/commands/objects/edit_keys.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/text/number_text.h"
#include "app/document/time/timeline.h"
#include "app/frames/picture_cache.h"
#include "app/panels/time/dope_sheet.h"
#include "app/panels/time/playback_label.h"
#include "app/panels/time/time_ruler.h"
#include "app/widgets/icons.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "app/widgets/whole_number_box.h"
#include "brume/limits.h"

namespace brume {
namespace {

// A frame number behind its label.
QSpinBox* add_number(QBoxLayout& row, TimelineBar* bar, const char* name, const QString& label,
                     const QString& tip) {
  auto* box = new WholeNumberBox(tip, 0, limits::frame, bar);
  QObject::connect(box, &WholeNumberBox::refused, bar, &TimelineBar::refused);
  box->setObjectName(name);
  box->setToolTip(tip);
  box->setAccessibleName(tip);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::ClickFocus);
  auto* title = new PlainLabel(bar);
  title->setText(label);
  title->setToolTip(tip);
  constexpr int gap = 4;  // pixels
  row.addSpacing(gap);
  row.addWidget(title);
  row.addSpacing(gap);
  row.addWidget(box);
  return box;
}

QToolButton* new_button(QWidget* bar, const char* icon, const QString& tip) {
  auto* button = named(new QToolButton(bar), icon, tip);
  button->setIcon(load_icon(icon));
  button->setAutoRaise(true);
  button->setAccessibleName(tip);
  return button;
}

std::size_t part_of(ObjectRef::Kind kind) {
  if (kind == ObjectRef::Kind::light) return index_of<Lights>();
  return kind == ObjectRef::Kind::emitter ? index_of<Emitters>() : index_of<Surfaces>();
}

}  // namespace

TimelineBar::TimelineBar(Timeline& timeline, Document& document, std::function<Camera()> view,
                         QWidget* parent)
    : QWidget(parent),
      timeline_(timeline),
      document_(document),
      view_(std::move(view)),
      ruler_(named(new TimeRuler(timeline, this), "frame_ruler")),
      sheet_(named(new DopeSheet(timeline, document, this), "keys")),
      playback_(named(new PlaybackLabel(timeline, this), "playback_rate")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 2, 8, 2);
  column->addLayout(row);
  add_playback(*row);
  add_range(*row);
  add_sheet(*column);
}

void TimelineBar::add_playback(QBoxLayout& row) {
  Timeline& timeline = timeline_;
  auto* to_first = new_button(this, "first_frame", tr("Go to the first frame"));
  auto* back = new_button(this, "step_back", tr("Previous frame (,)"));
  auto* play = new_button(this, "play", tr("Play (Space)"));
  auto* forward = new_button(this, "step_forward", tr("Next frame (.)"));
  for (QToolButton* button : {to_first, back, play, forward}) row.addWidget(button);
  QSpinBox* frame = add_number(row, this, "frame", tr("Frame"), tr("Frame"));
  auto* seconds = new PlainLabel(this);
  seconds->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("1000.00 s")));
  row.addWidget(seconds);
  row.addWidget(playback_);
  row.addStretch();
  connect(to_first, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.first()); });
  connect(back, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.frame() - 1); });
  connect(forward, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.frame() + 1); });
  connect(play, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.is_playing() ? timeline.stop() : timeline.play(); });
  connect(frame, &QSpinBox::valueChanged, &timeline, &Timeline::set_frame);
  const auto show = [=, &timeline] {
    const QSignalBlocker blocker(frame);
    play->setIcon(load_icon(timeline.is_playing() ? "pause" : "play"));
    frame->setValue(timeline.frame());
    seconds->setText(tr("%1 s").arg(fixed_text(timeline.time(), 2)));
  };
  connect(&timeline, &Timeline::changed, this, show);
  show();
}

void TimelineBar::add_range(QBoxLayout& row) {
  Timeline& timeline = timeline_;
  QSpinBox* first =
      add_number(row, this, "first_frame_of_range", tr("Start"), tr("First frame of the range"));
  QSpinBox* last =
      add_number(row, this, "last_frame_of_range", tr("End"), tr("Last frame of the range"));
  auto* loop = named(new QCheckBox(tr("Loop"), this), "loop",
                     tr("Playback begins again at the end of the range"));
  auto* curves = new_button(this, "curve", tr("Show or hide the curves of the animated values"));
  row.addWidget(loop);
  row.addWidget(curves);
  connect(first, &QSpinBox::valueChanged, &timeline, [this, &timeline](int value) {
    set_playback(
        {value, std::max(value, timeline.last()), timeline.loops(), timeline.frames_per_second()});
  });
  connect(last, &QSpinBox::valueChanged, &timeline, [this, &timeline](int value) {
    set_playback(
        {std::min(value, timeline.first()), value, timeline.loops(), timeline.frames_per_second()});
  });
  connect(loop, &QCheckBox::toggled, this, [this, &timeline](bool on) {
    set_playback({timeline.first(), timeline.last(), on, timeline.frames_per_second()});
  });
  connect(curves, &QToolButton::clicked, this, &TimelineBar::curves_asked_for);
  const auto show = [=, &timeline] {
    const QSignalBlocker blockers[]{QSignalBlocker(first), QSignalBlocker(last),
                                    QSignalBlocker(loop)};
    first->setValue(timeline.first());
    last->setValue(timeline.last());
    loop->setChecked(timeline.loops());
  };
  connect(&timeline, &Timeline::changed, this, show);
  show();
}

// The area has room for its scroll bar from the start, so that nothing moves when a row appears.
void TimelineBar::add_sheet(QBoxLayout& column) {
  auto* filter = named(new QLineEdit(this), "dope_filter",
                       tr("Shows the values that have this in their names"));
  filter->setPlaceholderText(tr("Filter"));
  filter->setAccessibleName(tr("Filter of animated values"));
  filter->setClearButtonEnabled(true);
  filter->setFixedWidth(DopeSheet::names_width);
  auto* area = new QScrollArea(this);
  area->setWidget(sheet_);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  constexpr int min_height = 22;  // pixels: a row
  area->setMinimumHeight(min_height);
  auto* ruler = new QHBoxLayout;
  ruler->setContentsMargins(0, 0, style()->pixelMetric(QStyle::PM_ScrollBarExtent), 0);
  ruler->setSpacing(0);
  ruler->addWidget(filter);
  ruler->addWidget(ruler_, 1);
  column.addLayout(ruler);
  column.addWidget(area, 1);
  connect(filter, &QLineEdit::textChanged, sheet_, &DopeSheet::set_filter);
}

QSize TimelineBar::sizeHint() const {
  constexpr int more_rows = 54;  // pixels: three
  return {400, minimumSizeHint().height() + more_rows};
}

void TimelineBar::picture_shown(double time) {
  playback_->picture_shown(time);
}

void TimelineBar::show_cached(const PictureCache& cache, int view) {
  std::vector<TimeRuler::Cached> frames;
  for (const PictureCache::Kept& kept : cache.kept(view)) {
    frames.push_back({static_cast<int>(std::round(timeline_.frame_of(kept.time))), kept.full});
  }
  ruler_->set_cached(std::move(frames));
}

void TimelineBar::set_playback(const Playback& playback) {
  set_scene_part(document_, std::optional(playback), tr("Set playback range"));
}

void TimelineBar::set_key() {
  const std::vector<Track> all = tracks(document_.scene());
  std::vector<Track> keyed = sheet_->chosen();
  if (const auto& object = document_.object(); object && keyed.empty()) {
    const auto first = std::ranges::find_if(all, [&object](const Track& track) {
      return track.part == part_of(object->kind) && track.place == object->index;
    });
    if (first != all.end()) keyed = {*first};
  }
  // The place of the camera is the first of all.
  if (keyed.empty() || keyed == std::vector{all.front()}) {
    set_camera_keys(document_, view_());
  } else {
    set_keys(document_, keyed);
  }
}

}  // namespace brume
