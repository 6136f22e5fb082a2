#include "app/viewport/vtk_host.h"

#include <GL/gl.h>
#include <vtkActor2D.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkOpenGLTexture.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <numeric>

namespace brume {

// All points or all segments of the overlay in one poly data with a colour per vertex: an actor
// for each Gaussian would be thousands of times slower.
class VtkHost::Shapes {
 public:
  Shapes(vtkRenderer& renderer, int points_per_cell) : points_per_cell_(points_per_cell) {
    coordinates_->SetNumberOfComponents(3);
    colors_->SetNumberOfComponents(4);
    mapper_->SetInputData(data_);
    actor_->SetMapper(mapper_);
    renderer.AddViewProp(actor_);
  }

  vtkProperty2D& property() { return *actor_->GetProperty(); }

  void set(const std::vector<Overlay::Vertex>& vertices, double height, double scale) {
    const auto count = static_cast<vtkIdType>(vertices.size());
    coordinates_->SetNumberOfTuples(count);
    colors_->SetNumberOfTuples(count);
    float* xyz = coordinates_->GetPointer(0);
    unsigned char* rgba = colors_->GetPointer(0);
    for (const Overlay::Vertex& v : vertices) {
      *xyz++ = static_cast<float>(v.x * scale);
      *xyz++ = static_cast<float>(height - v.y * scale);
      *xyz++ = 0.0F;
      *rgba++ = static_cast<unsigned char>(qRed(v.color));
      *rgba++ = static_cast<unsigned char>(qGreen(v.color));
      *rgba++ = static_cast<unsigned char>(qBlue(v.color));
      *rgba++ = static_cast<unsigned char>(qAlpha(v.color));
    }
    coordinates_->Modified();
    colors_->Modified();
    vtkNew<vtkPoints> points;
    points->SetData(coordinates_);
    data_->SetPoints(points);
    data_->GetPointData()->SetScalars(colors_);
    if (count != count_) set_cells(count);
    data_->Modified();
    actor_->SetVisibility(count > 0);
  }

 private:
  void set_cells(vtkIdType count) {
    count_ = count;
    vtkNew<vtkIdTypeArray> ids;
    ids->SetNumberOfValues(count);
    std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType{0});
    vtkNew<vtkCellArray> cells;
    cells->SetData(points_per_cell_, ids);
    if (points_per_cell_ == 1) {
      data_->SetVerts(cells);
    } else if (points_per_cell_ == 2) {
      data_->SetLines(cells);
    } else {
      data_->SetPolys(cells);
    }
  }

  int points_per_cell_;
  vtkIdType count_ = -1;
  vtkNew<vtkFloatArray> coordinates_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPolyDataMapper2D> mapper_;
  vtkNew<vtkActor2D> actor_;
};

VtkHost::VtkHost(Context context) : context_(std::move(context)) {
  // VTK 9.3 warns on the terminal that it cannot read sizes of channels; errors still appear.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_ERROR);
  window_->SetMultiSamples(0);
  window_->SetReadyForRendering(false);  // until there is a context
  window_->SetOwnContext(0);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetMapped(1);
  // Making a current QOpenGLWidget current again would bind its framebuffer behind VTK's back.
  observe(vtkCommand::WindowMakeCurrentEvent, [this](void*) {
    if (!context_.is_current()) context_.make_current();
  });
  observe(vtkCommand::WindowIsCurrentEvent,
          [this](void* answer) { *static_cast<bool*>(answer) = context_.is_current(); });
  observe(vtkCommand::WindowSupportsOpenGLEvent,
          [](void* answer) { *static_cast<int*>(answer) = 1; });
  observe(vtkCommand::WindowIsDirectEvent, [](void* answer) { *static_cast<int*>(answer) = 1; });

  renderer_->SetBackground(0.0, 0.0, 0.0);
  renderer_->SetBackgroundAlpha(1.0);
  window_->AddRenderer(renderer_);
  uploaded_->InterpolateOn();
  uploaded_->SetWrap(vtkTexture::ClampToEdge);
  shared_object_->SetMinificationFilter(vtkTextureObject::Linear);
  shared_object_->SetMagnificationFilter(vtkTextureObject::Linear);
  shared_object_->SetWrapS(vtkTextureObject::ClampToEdge);
  shared_object_->SetWrapT(vtkTextureObject::ClampToEdge);
  shared_->SetTextureObject(shared_object_);
  shapes_.push_back(std::make_unique<Shapes>(*renderer_, 3));
  shapes_.push_back(std::make_unique<Shapes>(*renderer_, 2));
  shapes_.push_back(std::make_unique<Shapes>(*renderer_, 1));
  shapes_.push_back(std::make_unique<Shapes>(*renderer_, 1));
}

VtkHost::~VtkHost() {
  gl_gone();
  window_->RemoveAllObservers();
}

void VtkHost::observe(unsigned long event, std::function<void(void*)> react) {
  reactions_.push_back(std::make_unique<std::function<void(void*)>>(std::move(react)));
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(reactions_.back().get());
  command->SetCallback([](vtkObject*, unsigned long, void* client, void* data) {
    (*static_cast<std::function<void(void*)>*>(client))(data);
  });
  window_->AddObserver(event, command);
}

void VtkHost::gl_ready() {
  window_->SetForceMaximumHardwareLineWidth(1);
  window_->SetReadyForRendering(true);
  window_->InitializeFromCurrentContext();
  ready_ = true;
}

void VtkHost::gl_gone() {
  if (!ready_) return;
  ready_ = false;
  context_.make_current();
  uploaded_->ReleaseGraphicsResources(window_);
  shared_->ReleaseGraphicsResources(window_);
  window_->Finalize();
  window_->SetReadyForRendering(false);
}

void VtkHost::resize(QSize size, double scale) {
  window_->SetSize(size.width(), size.height());
  scale_ = scale;
  rebuild_shapes();
}

QSize VtkHost::size() const {
  const int* size = const_cast<HostedRenderWindow*>(window_.Get())->GetSize();
  return {size[0], size[1]};
}

void VtkHost::show_picture(const QImage& picture) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  vtkNew<vtkImageData> image;
  image->SetDimensions(rgb.width(), rgb.height(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  const auto row = static_cast<std::size_t>(rgb.width()) * 3;
  for (int y = 0; y < rgb.height(); ++y) {
    std::memcpy(bytes + row * static_cast<std::size_t>(rgb.height() - 1 - y), rgb.scanLine(y), row);
  }
  uploaded_->SetInputData(image);
  renderer_->SetBackgroundTexture(uploaded_);
  renderer_->TexturedBackgroundOn();
  picture_.reset();
}

void VtkHost::show_picture(std::shared_ptr<gl::DevicePicture> picture) {
  picture_ = std::move(picture);
  renderer_->SetBackgroundTexture(shared_);
  renderer_->TexturedBackgroundOn();
}

void VtkHost::show_overlay(const Overlay& overlay) {
  overlay_ = overlay;
  rebuild_shapes();
}

void VtkHost::rebuild_shapes() {
  const double height = size().height();
  shapes_[0]->set(overlay_.triangles, height, scale_);
  shapes_[1]->set(overlay_.lines, height, scale_);
  shapes_[1]->property().SetLineWidth(static_cast<float>(Overlay::line_width() * scale_));
  shapes_[2]->set(overlay_.dots, height, scale_);
  shapes_[2]->property().SetPointSize(static_cast<float>(Overlay::dot_size() * scale_));
  shapes_[3]->set(overlay_.marks, height, scale_);
  shapes_[3]->property().SetPointSize(static_cast<float>(Overlay::mark_size() * scale_));
}

unsigned VtkHost::render() {
  // The context's owner changed OpenGL's state since the last frame; VTK keeps a copy of it.
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  if (picture_) {
    shared_object_->SetContext(window_);
    shared_object_->AssignToExistingTexture(picture_->texture().name(), GL_TEXTURE_2D);
    shared_object_->Modified();  // sets its filters, which another texture of that name had
  }
  window_->Render();
  if (picture_) picture_->drawn();
  state->Pop();
  vtkOpenGLFramebufferObject* result = window_->GetDisplayFramebuffer();
  return result ? result->GetFBOIndex() : 0;
}

}  // namespace brume
