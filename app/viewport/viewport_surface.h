#pragma once

#include <QImage>
#include <QString>

#include "app/viewport/overlay.h"

class QWidget;

namespace brume {

// What the viewport shows its picture on. Mouse and keys belong to the viewport around it.
class ViewportSurface {
 public:
  virtual ~ViewportSurface() = default;

  virtual QWidget* widget() = 0;
  virtual void show_picture(const QImage& picture) = 0;  // stretched over the surface
  virtual void show_overlay(const Overlay& overlay) = 0;

  // Why there is no OpenGL; empty if there is.
  [[nodiscard]] virtual QString gl_problem() const { return {}; }
};

// The best surface this platform can have: an OpenGL widget, else an image from an OpenGL context
// of our own, else Qt's painter. The surface's widget is a child of `parent`, which owns it.
ViewportSurface* create_viewport_surface(QWidget* parent);

}  // namespace brume
