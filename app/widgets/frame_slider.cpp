#include "app/widgets/frame_slider.h"

#include <QStyleOptionSlider>

namespace brume {

double FrameSlider::x_of(int value) const {
  QStyleOptionSlider option;
  initStyleOption(&option);
  option.sliderPosition = option.sliderValue = value;
  return QRectF(style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this))
      .center()
      .x();
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
