// GLEW is VTK's loader. Only this file includes it: it does not mix with epoxy or Qt's GL headers.
#include <GL/glew.h>

#include "app/viewport/hosted_render_window.h"

#include <vtkObjectFactory.h>

namespace brume {

// clang-format off
vtkStandardNewMacro(HostedRenderWindow)
    // clang-format on

    void HostedRenderWindow::OpenGLInitContext() {
  if (!Initialized) {
    const GLenum answer = glewInit();
    if (answer == GLEW_OK || answer == GLEW_ERROR_NO_GLX_DISPLAY) {
      GlewInitValid = true;
      Initialized = true;
      GLfloat range[2]{1.0F, 1.0F};
      glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
      MaximumHardwareLineWidth = range[1];
    }
  }
  vtkGenericOpenGLRenderWindow::OpenGLInitContext();  // does not call glewInit again
}

}  // namespace brume
