#pragma once

#include <QWidget>
#include <memory>

#include "app/viewport/viewport_surface.h"
#include "app/viewport/vtk_host.h"
#include "render/gl/egl_context.h"

namespace brume {

// VTK in an offscreen OpenGL context, read back and painted, where windows have no OpenGL.
class ImageViewport : public QWidget, public ViewportSurface {
  Q_OBJECT
 public:
  explicit ImageViewport(std::unique_ptr<EglContext> context, QWidget* parent = nullptr);
  ~ImageViewport() override;

  QWidget* widget() override { return this; }
  void show_picture(const QImage& picture) override;
  void show_picture(std::shared_ptr<gl::DevicePicture> picture) override;
  void show_overlay(const Overlay& overlay) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  std::unique_ptr<EglContext> context_;
  VtkHost host_;
};

}  // namespace brume
