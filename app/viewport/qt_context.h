#pragma once

#include <QOpenGLContext>
#include <memory>

#include "render/gl/context.h"

namespace brume {

// An offscreen OpenGL context that shares objects with all OpenGL widgets. Belongs to its creating
// thread.
class QtContext final : public gl::Context {
 public:
  // `surface`: offscreen, outlives the context; one per thread suffices. nullptr on failure.
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
