#pragma once

#include <QOpenGLWidget>
#include <QSurfaceFormat>

#include "app/viewport/viewport_surface.h"
#include "app/viewport/vtk_host.h"

namespace brume {

// VTK in an OpenGL widget, for desktops.
class GlViewport : public QOpenGLWidget, public ViewportSurface {
  Q_OBJECT
 public:
  explicit GlViewport(QWidget* parent = nullptr);
  ~GlViewport() override;

  static QSurfaceFormat surface_format();

  QWidget* widget() override { return this; }
  void show_picture(const QImage& picture) override;
  void show_picture(std::shared_ptr<gl::DevicePicture> picture) override;
  void show_overlay(const Overlay& overlay) override;

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;

 private:
  VtkHost host_;
};

}  // namespace brume
