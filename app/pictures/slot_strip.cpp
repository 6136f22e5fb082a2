#include "app/pictures/slot_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QScrollBar>
#include <QToolButton>
#include <utility>

#include "app/widgets/application.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

constexpr QSize thumbnail_size(96, 60);

QIcon thumbnail_of(const Picture* picture, int slot, double ratio) {
  QPixmap pixmap(thumbnail_size * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(QColor(24, 24, 26));
  QPainter painter(&pixmap);
  if (picture) {
    const QSize size = picture->image.size().scaled(thumbnail_size, Qt::KeepAspectRatio);
    const QRect place(QPoint((thumbnail_size.width() - size.width()) / 2,
                             (thumbnail_size.height() - size.height()) / 2),
                      size);
    painter.drawImage(place, picture->image.scaled(size * ratio, Qt::IgnoreAspectRatio,
                                                   Qt::SmoothTransformation));
  } else {
    painter.setPen(QColor(170, 173, 178));
    painter.drawText(QRect(QPoint(), thumbnail_size), Qt::AlignCenter, QString::number(slot + 1));
  }
  return pixmap;
}

}  // namespace

SlotStrip::SlotStrip(PictureSlots& slots, QWidget* parent)
    : QScrollArea(parent), slots_(slots), a_(new QButtonGroup(this)), b_(new QButtonGroup(this)) {
  auto* content = new QWidget;
  auto* row = new QHBoxLayout(content);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (int k = 0; k < static_cast<int>(PictureSlots::count); ++k) add_tile(*row, k);
  row->addStretch();
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFixedHeight(content->sizeHint().height() + horizontalScrollBar()->sizeHint().height());
  a_->button(0)->setChecked(true);
  b_->button(1)->setChecked(true);
  for (std::size_t slot = 0; slot < PictureSlots::count; ++slot) show_slot(slot);
  connect(&slots_, &PictureSlots::changed, this, &SlotStrip::show_slot);
  connect(&slots_, &PictureSlots::labelled, this, &SlotStrip::show_slot);
  for (const QButtonGroup* group : {a_, b_}) {
    connect(group, &QButtonGroup::idToggled, this, [this](int slot, bool on) {
      show_slot(static_cast<std::size_t>(slot));
      if (on) Q_EMIT chosen();
    });
  }
}

void SlotStrip::add_tile(QBoxLayout& row, int slot) {
  auto* thumbnail = named(new QToolButton, QString("slot_%1").arg(slot + 1));
  thumbnail->setIconSize(thumbnail_size);
  thumbnail->setAutoRaise(true);
  connect(thumbnail, &QToolButton::clicked, this,
          [this, slot] { choose_a(static_cast<std::size_t>(slot)); });
  auto* name = new PlainLabel;
  name->setFixedWidth(thumbnail_size.width() - 44);
  auto* names = new QHBoxLayout;
  names->setSpacing(2);
  names->addWidget(name);
  for (QButtonGroup* group : {a_, b_}) {
    const bool is_a = group == a_;
    auto* button = named(new QToolButton, QString("slot_%1_%2").arg(is_a ? "a" : "b").arg(slot + 1),
                         is_a ? tr("Shows slot %1 as A").arg(slot + 1)
                              : tr("Compares A with slot %1, as B").arg(slot + 1));
    button->setText(is_a ? tr("A") : tr("B"));
    button->setCheckable(true);
    button->setAutoRaise(true);
    group->addButton(button, slot);
    names->addWidget(button);
  }
  auto* tile = new QVBoxLayout;
  tile->setSpacing(1);
  tile->addWidget(thumbnail);
  tile->addLayout(names);
  row.addLayout(tile);
  tiles_.push_back({thumbnail, name});
}

void SlotStrip::show_slot(std::size_t slot) {
  const Picture* picture = slots_.at(slot).get();
  Tile& tile = tiles_[slot];
  const int number = static_cast<int>(slot);
  for (const QButtonGroup* group : {a_, b_}) {
    QAbstractButton* button = group->button(number);
    QPalette colors = palette();
    if (button->isChecked()) colors.setColor(QPalette::ButtonText, accent_color());
    button->setPalette(colors);
    QFont font = button->font();
    font.setBold(button->isChecked());
    button->setFont(font);
  }
  const qint64 shown = picture ? picture->image.cacheKey() : 0;
  if (std::exchange(tile.shown, shown) != shown) {
    tile.thumbnail->setIcon(thumbnail_of(picture, number, devicePixelRatioF()));
  }
  const QString name = slots_.name(slot);
  tile.name->setText(tile.name->fontMetrics().elidedText(name, Qt::ElideRight, tile.name->width()));
  QStringList lines;
  if (picture) lines << name << picture->details;
  if (!slots_.note(slot).isEmpty()) lines << slots_.note(slot);
  const QString tip =
      picture ? plain_tool_tip(lines.join('\n')) : tr("Slot %1, empty").arg(slot + 1);
  tile.thumbnail->setToolTip(tip);
  tile.name->setToolTip(tip);
}

}  // namespace brume
