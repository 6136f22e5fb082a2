#include "app/viewport/painter_viewport.h"

#include <QPainter>

namespace brume {

PainterViewport::PainterViewport(QString gl_problem, QWidget* parent)
    : QWidget(parent), gl_problem_(std::move(gl_problem)) {
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void PainterViewport::show_picture(const QImage& picture) {
  picture_ = picture;
  update();
}

void PainterViewport::show_overlay(const Overlay& overlay) {
  overlay_ = overlay;
  update();
}

void PainterViewport::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  if (picture_.isNull()) {
    painter.fillRect(rect(), Qt::black);
  } else {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), picture_);
  }
  paint(overlay_, painter);
  painter.setPen(QColor(255, 255, 255, 150));
  painter.drawText(rect().adjusted(12, 8, -12, -8), Qt::AlignTop | Qt::AlignLeft,
                   tr("No OpenGL: %1. The view is drawn without it.").arg(gl_problem_));
}

}  // namespace brume
