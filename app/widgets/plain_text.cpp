#include "app/widgets/plain_text.h"

#include <QPainter>
#include <QStyle>

namespace brume {
namespace {

constexpr int min_characters = 6;  // that a cut line keeps

}  // namespace

PlainLabel::PlainLabel(const QString& text, QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setText(text);
}

bool PlainLabel::is_line() const {
  return !wordWrap() && !text().isEmpty() && !text().contains('\n');
}

QSize PlainLabel::minimumSizeHint() const {
  QSize size = QLabel::minimumSizeHint();
  if (!is_line()) return size;
  size.setWidth(std::min(size.width(), min_characters * fontMetrics().averageCharWidth()));
  return size;
}

void PlainLabel::paintEvent(QPaintEvent* event) {
  const QString cut = fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
  if (!is_line() || cut == text()) {
    QLabel::paintEvent(event);
    return;
  }
  QPainter painter(this);
  drawFrame(&painter);
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), palette(),
                        isEnabled(), cut, foregroundRole());
}

QString plain_tool_tip(const QString& text) {
  return "<span>" + text.toHtmlEscaped().replace('\n', "<br>") + "</span>";
}

}  // namespace brume
