#pragma once

#include <QWidget>

#include "app/viewport/viewport_surface.h"

namespace brume {

// Draws with QPainter, without OpenGL.
class PainterViewport : public QWidget, public ViewportSurface {
  Q_OBJECT
 public:
  explicit PainterViewport(QString gl_problem, QWidget* parent = nullptr);

  QWidget* widget() override { return this; }
  void show_picture(const QImage& picture) override;
  void show_picture(std::shared_ptr<gl::DevicePicture> /*picture*/) override {}  // there are none
  void show_overlay(const Overlay& overlay) override;
  [[nodiscard]] QString gl_problem() const override { return gl_problem_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString gl_problem_;
  QImage picture_;
  Overlay overlay_;
};

}  // namespace brume
