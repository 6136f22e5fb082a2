#include "app/viewport/gl_viewport.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

namespace brume {

QSurfaceFormat GlViewport::surface_format() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);  // VTK draws into framebuffers of its own
  return format;
}

GlViewport::GlViewport(QWidget* parent)
    : QOpenGLWidget(parent),
      host_({.make_current = [this] { makeCurrent(); },
             .is_current =
                 [this] { return context() && QOpenGLContext::currentContext() == context(); }}) {
  setFormat(surface_format());
}

GlViewport::~GlViewport() {
  host_.gl_gone();
}

void GlViewport::show_picture(const QImage& picture) {
  host_.show_picture(picture);
  update();
}

void GlViewport::show_picture(std::shared_ptr<gl::DevicePicture> picture) {
  host_.show_picture(std::move(picture));
  update();
}

void GlViewport::show_overlay(const Overlay& overlay) {
  host_.show_overlay(overlay);
  update();
}

void GlViewport::initializeGL() {
  connect(
      context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { host_.gl_gone(); },
      Qt::DirectConnection);
  host_.gl_ready();
}

void GlViewport::resizeGL(int /*width*/, int /*height*/) {
  host_.resize((QSizeF(size()) * devicePixelRatioF()).toSize(), devicePixelRatioF());
}

void GlViewport::paintGL() {
  const unsigned drawn = host_.render();
  const QSize size = host_.size();
  auto* gl = context()->extraFunctions();
  const GLenum attachment = GL_COLOR_ATTACHMENT0;
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
  gl->glReadBuffer(attachment);
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDrawBuffers(1, &attachment);
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(),
                        GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  // VTK leaves alpha as it comes; Qt would show the window through the picture.
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace brume
