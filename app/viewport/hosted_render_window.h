#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace brume {

// VTK's window for contexts made by others, which also takes contexts made through EGL: GLEW
// answers for these that there is no GLX display, although it has loaded all entry points.
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
