#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace brume {

// VTK's render window for external contexts, including EGL ones, for which GLEW reports a missing
// GLX display although it has loaded all entry points.
class HostedRenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static HostedRenderWindow* New();
  vtkTypeMacro(HostedRenderWindow, vtkGenericOpenGLRenderWindow)

  void OpenGLInitContext() override;

 protected:
  HostedRenderWindow() = default;
  ~HostedRenderWindow() override = default;
};

}  // namespace brume
