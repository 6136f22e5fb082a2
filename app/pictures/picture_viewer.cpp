#include "app/pictures/picture_viewer.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "app/document/number_text.h"
#include "app/widgets/application.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

QString channels_text(const std::array<float, 3>& rgb) {
  return QString("%1 %2 %3")
      .arg(number_text(rgb[0], 4), number_text(rgb[1], 4), number_text(rgb[2], 4));
}

}  // namespace

PictureViewer::PictureViewer(QWidget* parent)
    : QWidget(parent),
      canvas_(new PictureCanvas(this)),
      a_(new QButtonGroup(this)),
      b_(new QButtonGroup(this)),
      mode_(named(new QComboBox(this), "picture_mode")),
      gain_(named(new QComboBox(this), "difference_gain")),
      info_(named(new PlainLabel(this), "picture_info")),
      pixel_(named(new PlainLabel(this), "picture_pixel")) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  auto* choice = new QHBoxLayout;
  choice->setSpacing(2);
  add_slots(*choice, *a_, tr("A"), "slot_a");
  choice->addSpacing(12);
  add_slots(*choice, *b_, tr("B"), "slot_b");
  choice->addStretch();
  layout->addLayout(choice);
  auto* tools = new QHBoxLayout;
  add_tools(*tools);
  layout->addLayout(tools);
  layout->addWidget(canvas_, 1);
  pixel_->setToolTip(tr("Linear radiance of the pixel under the mouse, red, green and blue"));
  layout->addWidget(info_);
  layout->addWidget(pixel_);
  a_->button(0)->setChecked(true);
  b_->button(1)->setChecked(true);

  connect(&slots_, &PictureSlots::changed, this, [this](std::size_t slot) {
    show_slot(slot);
    show_pictures();
  });
  connect(canvas_, &PictureCanvas::pointed_at, this, &PictureViewer::show_pixel);
  for (QButtonGroup* group : {a_, b_}) {
    connect(group, &QButtonGroup::idToggled, this, [this](int slot, bool on) {
      show_slot(static_cast<std::size_t>(slot));
      if (on) show_pictures();
    });
  }
  for (std::size_t slot = 0; slot < PictureSlots::count; ++slot) show_slot(slot);
  show_pictures();
}

void PictureViewer::add_slots(QBoxLayout& row, QButtonGroup& group, const QString& title,
                              const char* name) {
  row.addWidget(new QLabel(title, this));
  for (int k = 0; k < static_cast<int>(PictureSlots::count); ++k) {
    auto* button = new QToolButton(this);
    button->setText(QString::number(k + 1));
    button->setObjectName(QString("%1_%2").arg(name).arg(k + 1));
    button->setCheckable(true);
    button->setAutoRaise(true);
    group.addButton(button, k);
    row.addWidget(button);
  }
}

void PictureViewer::add_tools(QBoxLayout& row) {
  mode_->addItems({tr("A alone"), tr("Wipe A | B"), tr("Difference A − B")});
  mode_->setToolTip(tr("Wipe: A left and B right of a line; drag the line"));
  for (const int stops : {0, 2, 4, 6, 8}) gain_->addItem(tr("× %1").arg(1 << stops), stops);
  gain_->setToolTip(tr("How many times the difference is shown"));
  gain_->hide();
  connect(mode_, &QComboBox::currentIndexChanged, this, [this](int index) {
    canvas_->set_mode(static_cast<PictureCanvas::Mode>(index));
    gain_->setVisible(canvas_->mode() == PictureCanvas::Mode::difference);
    show_pictures();
  });
  connect(gain_, &QComboBox::currentIndexChanged, this, &PictureViewer::compare);
  row.addWidget(mode_);
  row.addWidget(gain_);
  row.addStretch();
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto react) {
    auto* button = named(new QPushButton(text, this), name, tip);
    connect(button, &QPushButton::clicked, this, react);
    row.addWidget(button);
  };
  add(tr("Fit"), "picture_fit", tr("Shows the whole picture"), [this] { canvas_->fit(); });
  add(tr("1:1"), "picture_actual", tr("A pixel of the picture on a pixel of the screen"),
      [this] { canvas_->actual_size(); });
  add(tr("Clear Slot"), "clear_slot", tr("Empties the slot that is shown as A"),
      [this] { slots_.set(static_cast<std::size_t>(a_->checkedId()), nullptr); });
  add(tr("Save…"), "save_picture",
      tr("Saves the picture that is shown as A, as it looks, as a PNG"), [this] {
        if (a()) Q_EMIT save_asked_for(a());
      });
  add(tr("Keep View"), "keep_view", tr("Keeps what the view shows in the next empty slot"),
      [this] { Q_EMIT keep_view_asked_for(); });
}

void PictureViewer::show_new(std::size_t slot) {
  const int shown = a_->checkedId();
  if (shown == static_cast<int>(slot)) return;
  if (a()) b_->button(shown)->setChecked(true);
  a_->button(static_cast<int>(slot))->setChecked(true);
}

const std::shared_ptr<const Picture>& PictureViewer::a() const {
  return slots_.at(static_cast<std::size_t>(a_->checkedId()));
}

const std::shared_ptr<const Picture>& PictureViewer::b() const {
  return slots_.at(static_cast<std::size_t>(b_->checkedId()));
}

void PictureViewer::show_slot(std::size_t slot) {
  const auto& picture = slots_.at(slot);
  for (QButtonGroup* group : {a_, b_}) {
    QAbstractButton* button = group->button(static_cast<int>(slot));
    QFont font = button->font();
    font.setBold(picture != nullptr);
    button->setFont(font);
    QPalette colors = palette();
    if (button->isChecked()) colors.setColor(QPalette::ButtonText, accent_color());
    button->setPalette(colors);
    button->setToolTip(picture ? plain_tool_tip(picture->name + '\n' + picture->details)
                               : tr("Slot %1, empty").arg(slot + 1));
  }
}

void PictureViewer::show_pictures() {
  canvas_->show_pictures(a(), b());
  show_info(std::nullopt);
  show_pixel(std::nullopt);
  compare();
}

void PictureViewer::compare() {
  comparing_.cancel();
  if (canvas_->mode() == PictureCanvas::Mode::single || !a() || !b()) return;
  const bool is_shown = canvas_->mode() == PictureCanvas::Mode::difference;
  comparing_.start([this, is_shown, first = a(), second = b(),
                    stops = gain_->currentData().toDouble()](const Job&) -> BackgroundJob::Apply {
    const QImage image = is_shown ? difference_image(*first, *second, stops) : QImage();
    return [this, image, difference = relative_difference(*first, *second)] {
      canvas_->show_difference(image);
      show_info(difference);
    };
  });
}

void PictureViewer::show_info(std::optional<double> difference) {
  const auto text = [](const QString& letter, const Picture& picture) {
    return QString("%1: %2 · %3").arg(letter, picture.name, picture.details);
  };
  QStringList lines;
  if (a()) lines << text(tr("A"), *a());
  if (canvas_->mode() != PictureCanvas::Mode::single && b()) {
    lines << text(tr("B"), *b());
    lines << (difference
                  ? tr("A differs from B by %1 (relative RMS)").arg(percent_text(*difference))
                  : QString(" "));
  }
  info_->setText(lines.join('\n'));
}

void PictureViewer::show_pixel(std::optional<QPoint> pixel) {
  if (!pixel || !a()) return pixel_->setText(" ");
  QString text = tr("Pixel %1, %2   A %3")
                     .arg(pixel->x())
                     .arg(pixel->y())
                     .arg(channels_text(a()->at(pixel->x(), pixel->y())));
  const bool compares = canvas_->mode() != PictureCanvas::Mode::single && b();
  if (compares && b()->width == a()->width && b()->height == a()->height) {
    text += tr("   B %1").arg(channels_text(b()->at(pixel->x(), pixel->y())));
  }
  pixel_->setText(text);
}

}  // namespace brume
