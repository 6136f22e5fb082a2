#include "app/viewport/viewport_surface.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QStringList>
#include <QWidget>

#include "app/viewport/gl_viewport.h"
#include "app/viewport/image_viewport.h"
#include "app/viewport/painter_viewport.h"
#include "app/viewport/qt_context.h"
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

ViewportSurfaces::ViewportSurfaces() {
  if (platform_has_gl_widgets()) {
    offscreen_ = std::make_unique<QOffscreenSurface>();
    offscreen_->setFormat(GlViewport::surface_format());
    offscreen_->create();
    return;
  }
  egl_ = EglContext::create(&gl_problem_);
  if (egl_) egl_->done_current();
}

ViewportSurfaces::~ViewportSurfaces() = default;

ViewportSurface* ViewportSurfaces::create(QWidget* parent) const {
  if (offscreen_) return new GlViewport(parent);
  std::string problem = gl_problem_;
  if (auto context = egl_ ? egl_->create_sharing(&problem) : nullptr) {
    return new ImageViewport(std::move(context), parent);
  }
  return new PainterViewport(QString::fromStdString(problem), parent);
}

std::unique_ptr<gl::Context> ViewportSurfaces::create_context() const {
  if (offscreen_) return QtContext::create(*offscreen_);
  return egl_ ? egl_->create_sharing() : nullptr;
}

}  // namespace brume
