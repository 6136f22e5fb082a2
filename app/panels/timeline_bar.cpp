#include "app/panels/timeline_bar.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include "app/icons.h"
#include "app/timeline.h"

namespace brume {
namespace {

constexpr int most_frames = 1'000'000;

QSpinBox* new_number(QWidget* parent, const char* name, const QString& tip) {
  auto* box = new QSpinBox(parent);
  box->setObjectName(name);
  box->setRange(0, most_frames);
  box->setToolTip(tip);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::ClickFocus);
  return box;
}

}  // namespace

TimelineBar::TimelineBar(Timeline& timeline, QWidget* parent) : QWidget(parent) {
  const QColor color = palette().color(QPalette::ButtonText);
  const auto button = [this, &color](const char* icon, const QString& tip) {
    auto* made = new QToolButton(this);
    made->setObjectName(icon);
    made->setIcon(load_icon(icon, color));
    made->setAutoRaise(true);
    made->setToolTip(tip);
    return made;
  };
  auto* to_first = button("first_frame", tr("To the first frame"));
  auto* back = button("step_back", tr("One frame back (,)"));
  auto* play = button("play", tr("Play (Space)"));
  auto* forward = button("step_forward", tr("One frame forward (.)"));
  auto* slider = new QSlider(Qt::Horizontal, this);
  slider->setObjectName("frame_slider");
  auto* frame = new_number(this, "frame", tr("Frame"));
  auto* seconds = new QLabel(this);
  auto* first = new_number(this, "first_frame_of_range", tr("First frame"));
  auto* last = new_number(this, "last_frame_of_range", tr("Last frame"));
  auto* loop = new QCheckBox(tr("Loop"), this);
  loop->setObjectName("loop");

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 8, 2);
  for (QToolButton* b : {to_first, back, play, forward}) row->addWidget(b);
  row->addWidget(frame);
  row->addWidget(slider, 1);
  row->addWidget(seconds);
  row->addWidget(first);
  row->addWidget(last);
  row->addWidget(loop);

  connect(to_first, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.first()); });
  connect(back, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.frame() - 1); });
  connect(forward, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.set_frame(timeline.frame() + 1); });
  connect(play, &QToolButton::clicked, &timeline,
          [&timeline] { timeline.is_playing() ? timeline.stop() : timeline.play(); });
  connect(slider, &QSlider::valueChanged, &timeline, &Timeline::set_frame);
  connect(frame, &QSpinBox::valueChanged, &timeline, &Timeline::set_frame);
  connect(first, &QSpinBox::valueChanged, &timeline,
          [&timeline](int value) { timeline.set_range(value, timeline.last()); });
  connect(last, &QSpinBox::valueChanged, &timeline,
          [&timeline](int value) { timeline.set_range(timeline.first(), value); });
  connect(loop, &QCheckBox::toggled, &timeline, &Timeline::set_loop);

  const auto show = [=, &timeline] {
    const QSignalBlocker blockers[]{QSignalBlocker(slider), QSignalBlocker(frame),
                                    QSignalBlocker(first), QSignalBlocker(last),
                                    QSignalBlocker(loop)};
    play->setIcon(load_icon(timeline.is_playing() ? "pause" : "play", color));
    slider->setRange(timeline.first(), timeline.last());
    slider->setValue(timeline.frame());
    frame->setValue(timeline.frame());
    seconds->setText(tr("%1 s").arg(timeline.time(), 0, 'f', 2));
    first->setValue(timeline.first());
    last->setValue(timeline.last());
    loop->setChecked(timeline.loops());
  };
  connect(&timeline, &Timeline::changed, this, show);
  show();
}

}  // namespace brume
