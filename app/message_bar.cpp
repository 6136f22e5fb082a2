#include "app/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace brume {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), label_(new QLabel(this)) {
  setObjectName("message_bar");
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton(this);
  close->setText(QString(QChar(0x2715)));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 4, 4, 4);
  layout->addWidget(label_, 1);
  layout->addWidget(close);
  hide();
}

void MessageBar::show_error(const QString& message) {
  show_message(message, "#6e2a2a");
}

void MessageBar::show_note(const QString& message) {
  show_message(message, "#33455c");
}

QString MessageBar::message() const {
  return label_->text();
}

void MessageBar::show_message(const QString& message, const QString& color) {
  setStyleSheet(QString("#message_bar { background: %1; } #message_bar QLabel { color: #f4f4f4; }")
                    .arg(color));
  label_->setText(message);
  show();
}

}  // namespace brume
