#include "app/window/pages/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), label_(new PlainLabel(this)), offers_(new QHBoxLayout) {
  setObjectName("message_bar");
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton(this);
  close->setText(QString(QChar(0x2715)));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 4, 4, 4);
  layout->addWidget(label_, 1);
  layout->addLayout(offers_);
  layout->addWidget(close);
  hide();
}

void MessageBar::show_error(const QString& message) {
  show_message(message, "#6e2a2a", {});
}

void MessageBar::show_note(const QString& message) {
  show_message(message, "#33455c", {});
}

void MessageBar::show_offers(const QString& message, const std::vector<Offer>& offers) {
  show_message(message, "#33455c", offers);
}

QString MessageBar::message() const {
  return label_->text();
}

void MessageBar::show_message(const QString& message, const QString& color,
                              const std::vector<Offer>& offers) {
  setStyleSheet(QString("#message_bar { background: %1; } #message_bar QLabel { color: #f4f4f4; }")
                    .arg(color));
  label_->setText(message);
  while (QLayoutItem* item = offers_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();  // it may be the one that is being pressed
    delete item;
  }
  for (const Offer& offer : offers) {
    auto* button = named(new QPushButton(offer.text, this), offer.name);
    offers_->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, react = offer.react] {
      hide();
      react();
    });
  }
  show();
}

}  // namespace brume
