#include "app/panels/time/timeline_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/commands/edit_keys.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/number_text.h"
#include "app/document/timeline.h"
#include "app/frames/picture_cache.h"
#include "app/panels/time/keyframe_track.h"
#include "app/panels/time/playback_label.h"
#include "app/widgets/frame_slider.h"
#include "app/widgets/icons.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "app/widgets/whole_number_box.h"
#include "brume/limits.h"

namespace brume {
namespace {

QSpinBox* new_number(TimelineBar* bar, const char* name, const QString& tip) {
  auto* box = new WholeNumberBox(tip, 0, limits::frame, bar);
  QObject::connect(box, &WholeNumberBox::refused, bar, &TimelineBar::refused);
  box->setObjectName(name);
  box->setToolTip(tip);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::ClickFocus);
  return box;
}

}  // namespace

TimelineBar::TimelineBar(Timeline& timeline, Document& document, std::function<Camera()> view,
                         QWidget* parent)
    : QWidget(parent),
      timeline_(timeline),
      document_(document),
      view_(std::move(view)),
      slider_(new FrameSlider(this)),
      playback_(named(new PlaybackLabel(timeline, this), "playback_rate")),
      target_(named(new QComboBox(this), "key_target")),
      keys_(named(new KeyframeTrack(timeline, document, this), "keys")),
      key_area_(new QScrollArea(this)) {
  const auto button = [this](const char* icon, const QString& tip) {
    auto* made = named(new QToolButton(this), icon);
    made->setIcon(load_icon(icon));
    made->setAutoRaise(true);
    made->setToolTip(tip);
    return made;
  };
  auto* to_first = button("first_frame", tr("Go to the first frame"));
  auto* back = button("step_back", tr("Previous frame (,)"));
  auto* play = button("play", tr("Play (Space)"));
  auto* forward = button("step_forward", tr("Next frame (.)"));
  FrameSlider* slider = slider_;
  slider->setObjectName("frame_slider");
  slider->setToolTip(
      tr("Drag to another frame. The bar below shows which frames are cached: bright "
         "at full quality, dim as they were shown during playback."));
  auto* frame = new_number(this, "frame", tr("Frame"));
  auto* seconds = new PlainLabel(this);
  auto* first = new_number(this, "first_frame_of_range", tr("First frame"));
  auto* last = new_number(this, "last_frame_of_range", tr("Last frame"));
  auto* loop = named(new QCheckBox(tr("Loop"), this), "loop");

  target_->setToolTip(tr("The value to set a keyframe for"));
  target_->setFocusPolicy(Qt::ClickFocus);
  target_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* key = button("key", tr("Set a keyframe of this value at the current frame (I)"));

  auto* curves = button("curve", tr("Show or hide the curves of the animated values"));

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  key_area_->setWidget(keys_);
  key_area_->setWidgetResizable(true);
  key_area_->setFrameShape(QFrame::NoFrame);
  key_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(key_area_);
  column->addStretch();
  row->setContentsMargins(8, 2, 8, 2);
  for (QToolButton* b : {to_first, back, play, forward}) row->addWidget(b);
  row->addWidget(frame);
  row->addWidget(slider, 1);
  row->addWidget(seconds);
  row->addWidget(playback_);
  row->addWidget(first);
  row->addWidget(last);
  row->addWidget(loop);
  row->addWidget(target_);
  row->addWidget(key);
  row->addWidget(curves);

  connect(to_first, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.first()); });
  connect(back, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.frame() - 1); });
  connect(forward, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.frame() + 1); });
  connect(play, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.is_playing() ? timeline.stop() : timeline.play(); });
  connect(slider, &QSlider::valueChanged, &timeline, &Timeline::set_frame);
  // Keys stand below the frames of the slider.
  connect(slider, &FrameSlider::moved, keys_, [this, slider] {
    const int left = slider->x() - key_area_->x();
    keys_->set_ends(left + slider->x_of(slider->minimum()), left + slider->x_of(slider->maximum()));
  });
  connect(frame, &QSpinBox::valueChanged, &timeline, &Timeline::set_frame);
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
  connect(key, &QToolButton::clicked, this, &TimelineBar::set_key);
  on_change(document_, Change::scene | Change::part | Change::object, this,
            &TimelineBar::refresh_targets);
  on_change(document_, Change::scene | Change::part, this, &TimelineBar::fit_keys);
  refresh_targets();
  fit_keys();

  const auto show = [=, &timeline] {
    const QSignalBlocker blockers[]{QSignalBlocker(slider), QSignalBlocker(frame),
                                    QSignalBlocker(first), QSignalBlocker(last),
                                    QSignalBlocker(loop)};
    play->setIcon(load_icon(timeline.is_playing() ? "pause" : "play"));
    slider->setRange(timeline.first(), timeline.last());
    slider->setValue(timeline.frame());
    frame->setValue(timeline.frame());
    seconds->setText(tr("%1 s").arg(fixed_text(timeline.time(), 2)));
    first->setValue(timeline.first());
    last->setValue(timeline.last());
    loop->setChecked(timeline.loops());
  };
  connect(&timeline, &Timeline::changed, this, show);
  show();
}

void TimelineBar::picture_shown(double time) {
  playback_->picture_shown(time);
}

void TimelineBar::show_cached(const PictureCache& cache, int view) {
  std::vector<FrameSlider::Cached> frames;
  for (const PictureCache::Kept& kept : cache.kept(view)) {
    frames.push_back({static_cast<int>(std::round(timeline_.frame_of(kept.time))), kept.full});
  }
  slider_->set_cached(std::move(frames));
}

void TimelineBar::set_playback(const Playback& playback) {
  set_scene_part(document_, std::optional(playback), tr("Set playback range"));
}

void TimelineBar::fit_keys() {
  constexpr int max_value = 112;  // pixels: six rows
  key_area_->setVisible(!keys_->rows().empty());
  key_area_->setFixedHeight(std::min(max_value, keys_->sizeHint().height()));
}

// Many surfaces give only the selected one: a list of the values of hundreds would be of no use.
std::vector<Track> TimelineBar::targets() const {
  constexpr std::size_t max_surfaces = 16;
  std::vector<Track> rows = tracks(document_.scene());
  if (document_.scene().surfaces.size() > max_surfaces) {
    std::erase_if(rows, [this](const Track& row) {
      return row.surface && row.surface != document_.object();
    });
  }
  return rows;
}

void TimelineBar::refresh_targets() {
  rows_ = targets();
  QStringList titles;
  for (const Track& row : rows_) titles << row.title;
  QStringList shown;
  for (int k = 0; k < target_->count(); ++k) shown << target_->itemText(k);
  if (titles == shown) return;
  const QString chosen = target_->currentText();
  target_->clear();
  target_->addItems(titles);
  target_->setCurrentIndex(std::max(0, target_->findText(chosen)));
}

void TimelineBar::set_key() {
  const auto k = static_cast<std::size_t>(target_->currentIndex());
  if (k >= rows_.size()) return;
  // That of its place is the first: the key is that of the view.
  if (k == 0) {
    set_camera_keys(document_, view_());
  } else {
    set_keys(document_, rows_[k]);
  }
}

}  // namespace brume
