#pragma once

#include <vtkNew.h>

#include <QImage>
#include <QSize>
#include <functional>
#include <memory>
#include <vector>

#include "app/view/drawing/overlay.h"
#include "app/viewport/hosted_render_window.h"
#include "render/gl/picture_pool.h"

class vtkOpenGLTexture;
class vtkRenderer;
class vtkTexture;
class vtkTextureObject;

namespace brume {

// VTK without VTK's Qt module: a render window inside somebody else's OpenGL context, showing the
// picture and the overlay. What owns the context drives it: gl_ready(), resize(), render(), and
// gl_gone() before the context goes.
class VtkHost {
 public:
  struct Context {
    std::function<void()> make_current;
    std::function<bool()> is_current;
  };
  explicit VtkHost(Context context);
  ~VtkHost();
  VtkHost(const VtkHost&) = delete;
  VtkHost& operator=(const VtkHost&) = delete;

  void gl_ready();  // the context is current for the first time
  void gl_gone();

  // `size` in device pixels; `scale` of those to a logical pixel.
  void resize(QSize size, double scale);
  [[nodiscard]] QSize size() const;

  void show_picture(const QImage& picture);
  // Shows a picture of a context that shares its objects with this one.
  void show_picture(std::shared_ptr<gl::DevicePicture> picture);
  void show_overlay(const Overlay& overlay);

  // Draws; answers the framebuffer that holds the result in its first colour attachment.
  unsigned render();

 private:
  class Shapes;
  void observe(unsigned long event, std::function<void(void*)> react);
  void rebuild_shapes();

  Context context_;
  std::vector<std::unique_ptr<std::function<void(void*)>>> reactions_;
  vtkNew<HostedRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkTexture> uploaded_;
  vtkNew<vtkOpenGLTexture> shared_;  // of picture_
  vtkNew<vtkTextureObject> shared_object_;
  std::shared_ptr<gl::DevicePicture> picture_;   // null: it is uploaded_ that is shown
  std::vector<std::unique_ptr<Shapes>> shapes_;  // triangles, lines, dots, marks
  Overlay overlay_;
  double scale_ = 1.0;
  bool ready_ = false;
};

}  // namespace brume
