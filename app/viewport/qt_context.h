#pragma once

#include <QOpenGLContext>
#include <memory>

#include "render/gl/context.h"

namespace brume {

// An OpenGL context without a window that shares its objects with all OpenGL widgets. It belongs to
// the thread that makes it.
class QtContext final : public gl::Context {
 public:
  // `surface` is no window, and outlives the context; one surface will do for one thread. nullptr:
  // there is no such context.
  static std::unique_ptr<QtContext> create(QSurface& surface);

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

}  // namespace brume
