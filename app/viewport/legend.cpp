#include "app/viewport/legend.h"

#include <QPainter>

namespace brume {
namespace {

constexpr int bar_width = 240;
constexpr int bar_height = 8;
constexpr int margin = 6;

}  // namespace

Legend::Legend(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void Legend::show_scale(const ColorScale& scale) {
  scale_ = scale;
  setVisible(!scale.title.isEmpty());
  resize(sizeHint());
  update();
}

QSize Legend::sizeHint() const {
  const int line = fontMetrics().height();
  const int bar = scale_.ticks.isEmpty() ? 0 : bar_height + line + 4;
  return {std::max(bar_width, fontMetrics().horizontalAdvance(scale_.title)) + 2 * margin,
          line + bar + 2 * margin};
}

void Legend::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(0, 0, 0, 150));
  painter.setPen(QColor(235, 238, 242));
  const int line = fontMetrics().height();
  const QRect inside = rect().adjusted(margin, margin, -margin, -margin);
  painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft, scale_.title);
  if (scale_.ticks.isEmpty()) return;
  const QRect bar(inside.left(), inside.top() + line + 2, inside.width(), bar_height);
  for (int x = 0; x < bar.width(); ++x) {
    painter.fillRect(bar.left() + x, bar.top(), 1, bar.height(),
                     QColor(false_color(static_cast<double>(x) / (bar.width() - 1))));
  }
  const QRect below(inside.left(), bar.bottom() + 2, inside.width(), line);
  for (qsizetype k = 0; k < scale_.ticks.size(); ++k) {
    const int width = fontMetrics().horizontalAdvance(scale_.ticks[k]) + 2;
    const int column = static_cast<int>(k * (below.width() - 1) / (scale_.ticks.size() - 1));
    const int left = std::clamp(column - width / 2, 0, below.width() - width);
    painter.drawText(QRect(below.left() + left, below.top(), width, line), Qt::AlignCenter,
                     scale_.ticks[k]);
  }
}

}  // namespace brume
