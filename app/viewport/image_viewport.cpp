#include "app/viewport/image_viewport.h"

#include <QPainter>

namespace brume {

ImageViewport::ImageViewport(std::unique_ptr<EglContext> context, QWidget* parent)
    : QWidget(parent),
      context_(std::move(context)),
      host_({.make_current = [this] { context_->make_current(); },
             .is_current = [this] { return context_->is_current(); }}) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  context_->make_current();
  host_.gl_ready();
}

ImageViewport::~ImageViewport() {
  host_.gl_gone();
}

void ImageViewport::show_picture(const QImage& picture) {
  host_.show_picture(picture);
  update();
}

void ImageViewport::show_picture(std::shared_ptr<gl::DevicePicture> picture) {
  host_.show_picture(std::move(picture));
  update();
}

void ImageViewport::show_overlay(const Overlay& overlay) {
  host_.show_overlay(overlay);
  update();
}

void ImageViewport::resizeEvent(QResizeEvent* /*event*/) {
  context_->make_current();
  host_.resize((QSizeF(size()) * devicePixelRatioF()).toSize(), devicePixelRatioF());
}

void ImageViewport::paintEvent(QPaintEvent* /*event*/) {
  context_->make_current();
  const unsigned drawn = host_.render();
  const QSize size = host_.size();
  QImage image(size, QImage::Format_RGBX8888);  // VTK's alpha means nothing here
  context_->read_rgba(drawn, size.width(), size.height(), image.bits());
  image = std::move(image).mirrored();
  image.setDevicePixelRatio(devicePixelRatioF());
  QPainter(this).drawImage(0, 0, image);
}

}  // namespace brume
