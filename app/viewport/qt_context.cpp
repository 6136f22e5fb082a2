#include "app/viewport/qt_context.h"

#include "app/viewport/gl_viewport.h"

namespace brume {

std::unique_ptr<QtContext> QtContext::create(QSurface& surface) {
  QOpenGLContext* shared = QOpenGLContext::globalShareContext();
  if (!shared || !QOpenGLContext::supportsThreadedOpenGL()) return nullptr;
  std::unique_ptr<QtContext> result(new QtContext(surface));
  QOpenGLContext& context = result->context_;
  context.setFormat(GlViewport::surface_format());
  context.setShareContext(shared);
  // Without sharing Qt makes one that stands alone.
  if (!context.create() || !QOpenGLContext::areSharing(&context, shared)) return nullptr;
  return result;
}

}  // namespace brume
