#pragma once

#include <QImage>
#include <QString>
#include <memory>
#include <string>

#include "app/view/drawing/overlay.h"
#include "render/gl/context.h"
#include "render/gl/picture_pool.h"

class QOffscreenSurface;
class QWidget;

namespace brume {

class EglContext;

// Display surface of a viewport. Input belongs to the viewport.
class ViewportSurface {
 public:
  virtual ~ViewportSurface() = default;

  virtual QWidget* widget() = 0;
  virtual void show_picture(const QImage& picture) = 0;  // stretched over the surface
  // From a context that shares its objects with this surface's, see ViewportSurfaces.
  virtual void show_picture(std::shared_ptr<gl::DevicePicture> picture) = 0;
  virtual void show_overlay(const Overlay& overlay) = 0;

  // Why there is no OpenGL; empty if there is.
  [[nodiscard]] virtual QString gl_problem() const { return {}; }
};

// Creates the best surfaces of the platform: OpenGL widgets, else images from offscreen contexts,
// else QPainter. Lives in the GUI thread and outlives its surfaces.
class ViewportSurfaces {
 public:
  ViewportSurfaces();
  ~ViewportSurfaces();

  // The widget is a child of `parent`, which owns it.
  ViewportSurface* create(QWidget* parent) const;

  // A context that shares objects with all surfaces, for any one thread; nullptr if none.
  [[nodiscard]] std::unique_ptr<gl::Context> create_context() const;

 private:
  std::unique_ptr<QOffscreenSurface> offscreen_;  // where surfaces are OpenGL widgets
  std::unique_ptr<EglContext> egl_;               // what contexts of our own share
  std::string gl_problem_;
};

}  // namespace brume
