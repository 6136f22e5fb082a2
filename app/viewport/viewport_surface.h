#pragma once

#include <QImage>
#include <QString>
#include <memory>
#include <string>

#include "app/viewport/overlay.h"
#include "render/gl/context.h"
#include "render/gl/picture_pool.h"

class QOffscreenSurface;
class QWidget;

namespace brume {

class EglContext;

// What the viewport shows its picture on. Mouse and keys belong to the viewport around it.
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

// Makes the best surfaces this platform can have: OpenGL widgets, else images from OpenGL contexts
// of our own, else Qt's painter. Lives in the interface's thread, longer than what it makes.
class ViewportSurfaces {
 public:
  ViewportSurfaces();
  ~ViewportSurfaces();

  // Its widget is a child of `parent`, which owns it.
  ViewportSurface* create(QWidget* parent) const;

  // A context that shares its objects with all surfaces; nullptr where there is none. For one
  // thread, whichever that is.
  [[nodiscard]] std::unique_ptr<gl::Context> create_context() const;

 private:
  std::unique_ptr<QOffscreenSurface> offscreen_;  // where surfaces are OpenGL widgets
  std::unique_ptr<EglContext> egl_;               // what contexts of our own share
  std::string gl_problem_;
};

}  // namespace brume
