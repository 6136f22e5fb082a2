#include "app/viewport/viewport_surface.h"

#include <QGuiApplication>
#include <QOpenGLContext>
#include <QStringList>
#include <QWidget>

#include "app/viewport/gl_viewport.h"
#include "app/viewport/image_viewport.h"
#include "app/viewport/painter_viewport.h"
#include "render/gl/egl_context.h"

namespace brume {
namespace {

// On other platforms merely showing a QOpenGLWidget may crash inside Qt, even where a context can
// be had (offscreen with a DISPLAY), so this is decided by name first.
bool platform_has_gl_widgets() {
  static const QStringList platforms{"xcb", "wayland", "wayland-egl", "windows", "cocoa"};
  if (!platforms.contains(QGuiApplication::platformName())) return false;
  QOpenGLContext probe;
  probe.setFormat(GlViewport::surface_format());
  return probe.create() && probe.format().version() >= std::pair(4, 5);
}

}  // namespace

ViewportSurface* create_viewport_surface(QWidget* parent) {
  if (platform_has_gl_widgets()) return new GlViewport(parent);
  std::string problem;
  if (auto context = EglContext::create(&problem)) {
    return new ImageViewport(std::move(context), parent);
  }
  return new PainterViewport(QString::fromStdString(problem), parent);
}

}  // namespace brume
