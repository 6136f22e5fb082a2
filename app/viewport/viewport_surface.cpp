#include "app/viewport/viewport_surface.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>
#include <QPainter>
#include <QStringList>
#include <QWidget>

#include "app/viewport/vtk_host.h"
#include "render/gl/egl_context.h"

namespace brume {
namespace {

QSurfaceFormat surface_format() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);  // VTK draws into framebuffers of its own
  return format;
}

// VTK in a widget.
template <class Widget>
class VtkSurface : public Widget, public ViewportSurface {
 public:
  VtkSurface(VtkHost::Context context, QWidget* parent)
      : Widget(parent), host_(std::move(context)) {}

  QWidget* widget() override { return this; }
  void show_picture(const QImage& picture) override {
    host_.show_picture(picture);
    this->update();
  }
  void show_picture(std::shared_ptr<gl::DevicePicture> picture) override {
    host_.show_picture(std::move(picture));
    this->update();
  }
  void show_overlay(const Overlay& overlay) override {
    host_.show_overlay(overlay);
    this->update();
  }

 protected:
  void fit() {
    const double scale = this->devicePixelRatioF();
    host_.resize((QSizeF(this->size()) * scale).toSize(), scale);
  }

  VtkHost host_;
};

// An OpenGL widget, for desktops.
class GlViewport : public VtkSurface<QOpenGLWidget> {
 public:
  explicit GlViewport(QWidget* parent)
      : VtkSurface(
            {.make_current = [this] { makeCurrent(); },
             .is_current =
                 [this] { return context() && QOpenGLContext::currentContext() == context(); }},
            parent) {
    setFormat(surface_format());
  }
  ~GlViewport() override {
    if (context()) context()->disconnect(this);
    host_.gl_gone();
  }
  GlViewport(const GlViewport&) = delete;
  GlViewport& operator=(const GlViewport&) = delete;

 protected:
  void initializeGL() override {
    connect(
        context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { host_.gl_gone(); },
        Qt::DirectConnection);
    host_.gl_ready();
  }
  void resizeGL(int /*width*/, int /*height*/) override { fit(); }
  void paintGL() override {
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
};

// An offscreen OpenGL context, read back and painted, where windows have no OpenGL.
class ImageViewport : public VtkSurface<QWidget> {
 public:
  ImageViewport(const std::shared_ptr<EglContext>& context, QWidget* parent)
      : VtkSurface({.make_current = [context] { context->make_current(); },
                    .is_current = [context] { return context->is_current(); }},
                   parent),
        context_(*context) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    context_.make_current();
    host_.gl_ready();
  }

 protected:
  void resizeEvent(QResizeEvent* /*event*/) override {
    context_.make_current();
    fit();
  }
  void paintEvent(QPaintEvent* /*event*/) override {
    context_.make_current();
    const unsigned drawn = host_.render();
    const QSize size = host_.size();
    QImage image(size, QImage::Format_RGBX8888);  // VTK's alpha means nothing here
    context_.read_rgba(drawn, size.width(), size.height(), image.bits());
    image = std::move(image).mirrored();
    image.setDevicePixelRatio(devicePixelRatioF());
    QPainter(this).drawImage(0, 0, image);
  }

 private:
  EglContext& context_;  // which the host keeps
};

// Draws without OpenGL.
class PainterViewport : public QWidget, public ViewportSurface {
 public:
  PainterViewport(QString gl_problem, QWidget* parent)
      : QWidget(parent), gl_problem_(std::move(gl_problem)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
  }

  QWidget* widget() override { return this; }
  void show_picture(const QImage& picture) override {
    picture_ = picture;
    update();
  }
  void show_picture(std::shared_ptr<gl::DevicePicture> /*picture*/) override {}  // there are none
  void show_overlay(const Overlay& overlay) override {
    overlay_ = overlay;
    update();
  }
  [[nodiscard]] QString gl_problem() const override { return gl_problem_; }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
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

 private:
  QString gl_problem_;
  QImage picture_;
  Overlay overlay_;
};

// An offscreen OpenGL context that shares objects with all OpenGL widgets. Belongs to its creating
// thread.
class QtContext final : public gl::Context {
 public:
  // `surface`: offscreen, outlives the context; one per thread suffices. nullptr on failure.
  static std::unique_ptr<QtContext> create(QSurface& surface) {
    QOpenGLContext* shared = QOpenGLContext::globalShareContext();
    if (!shared || !QOpenGLContext::supportsThreadedOpenGL()) return nullptr;
    std::unique_ptr<QtContext> result(new QtContext(surface));
    QOpenGLContext& context = result->context_;
    context.setFormat(surface_format());
    context.setShareContext(shared);
    // Without sharing Qt makes one that stands alone.
    if (!context.create() || !QOpenGLContext::areSharing(&context, shared)) return nullptr;
    return result;
  }

  bool make_current() override { return context_.makeCurrent(&surface_); }
  void done_current() override { context_.doneCurrent(); }
  [[nodiscard]] bool is_current() const override {
    return QOpenGLContext::currentContext() == &context_;
  }

 private:
  explicit QtContext(QSurface& surface) : surface_(surface) {}

  QSurface& surface_;
  QOpenGLContext context_;
};

// On other platforms merely showing a QOpenGLWidget may crash inside Qt, even where a context can
// be had (offscreen with a DISPLAY), so this is decided by name first.
bool platform_has_gl_widgets() {
  static const QStringList platforms{"xcb", "wayland", "wayland-egl", "windows", "cocoa"};
  if (!platforms.contains(QGuiApplication::platformName())) return false;
  QOpenGLContext probe;
  probe.setFormat(surface_format());
  return probe.create() && probe.format().version() >= std::pair(4, 5);
}

}  // namespace

ViewportSurfaces::ViewportSurfaces() {
  if (platform_has_gl_widgets()) {
    offscreen_ = std::make_unique<QOffscreenSurface>();
    offscreen_->setFormat(surface_format());
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
  if (std::shared_ptr<EglContext> context = egl_ ? egl_->create_sharing(&problem) : nullptr) {
    return new ImageViewport(context, parent);
  }
  return new PainterViewport(QString::fromStdString(problem), parent);
}

std::unique_ptr<gl::Context> ViewportSurfaces::create_context() const {
  if (offscreen_) return QtContext::create(*offscreen_);
  return egl_ ? egl_->create_sharing() : nullptr;
}

}  // namespace brume
