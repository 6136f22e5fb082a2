#include "app/widgets/frame_slider.h"

#include <QPainter>
#include <QStyleOptionSlider>
#include <algorithm>

#include "app/widgets/application.h"

namespace brume {

double FrameSlider::x_of(int value) const {
  QStyleOptionSlider option;
  initStyleOption(&option);
  option.sliderPosition = option.sliderValue = value;
  return QRectF(style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this))
      .center()
      .x();
}

void FrameSlider::set_cached(std::vector<Cached> frames) {
  if (frames == cached_) return;
  cached_ = std::move(frames);
  update();
}

void FrameSlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  if (cached_.empty()) return;
  QPainter painter(this);
  const double first = x_of(minimum());
  const double length = std::max(1, maximum() - minimum());
  const double step = (x_of(maximum()) - first) / length;
  constexpr double thickness = 3.0;
  QColor draft = accent_color();
  draft.setAlphaF(0.4F);
  for (const Cached& cached : cached_) {
    if (cached.frame < minimum() || cached.frame > maximum()) continue;
    const double x = first + step * (cached.frame - minimum());
    painter.fillRect(QRectF(x - 0.5 * step, height() - thickness, std::max(step, 1.0), thickness),
                     cached.full ? accent_color() : draft);
  }
}

void FrameSlider::resizeEvent(QResizeEvent* event) {
  QSlider::resizeEvent(event);
  Q_EMIT moved();
}

void FrameSlider::moveEvent(QMoveEvent* event) {
  QSlider::moveEvent(event);
  Q_EMIT moved();
}

}  // namespace brume
