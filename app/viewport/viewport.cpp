#include "app/viewport/viewport.h"

#include <QMouseEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "app/document/document.h"
#include "app/tools/gizmo.h"
#include "app/tools/tool.h"
#include "app/viewport/bounds.h"
#include "app/viewport/navigation.h"
#include "app/viewport/viewport_surface.h"
#include "core/authoring/contribution.h"
#include "core/authoring/particles.h"
#include "core/io/number_domain.h"
#include "render/settings.h"

namespace brume {
namespace {

constexpr int rest_after = 150;  // milliseconds without a change
constexpr int motion_slices = 8;
constexpr double least_depth = 0.02;  // optical depth of a Gaussian that can be pointed at

bool can_be_stored(const Camera& camera) {
  for (int k = 0; k < 3; ++k) {
    if (!domain::coordinate.contains(camera.eye[k])) return false;
    if (!domain::coordinate.contains(camera.target[k])) return false;
  }
  return camera.eye != camera.target;
}

}  // namespace

Viewport::Viewport(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      surface_(create_viewport_surface(this)),
      surfaces_(document),
      transfer_job_(new TransferJob(this)),
      band_(QRubberBand::Rectangle, this),
      camera_(document.scene().camera),
      frames_(transfer_job_->transfers()) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(surface_->widget());
  surface_->widget()->setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);

  overlay_timer_.setSingleShot(true);
  connect(&overlay_timer_, &QTimer::timeout, this, &Viewport::draw_overlay);
  rest_timer_.setSingleShot(true);
  connect(&rest_timer_, &QTimer::timeout, this, &Viewport::request_at_rest);

  connect(&frames_, &FrameService::frame_ready, this, &Viewport::take_frame);
  connect(&frames_, &FrameService::failed, this, &Viewport::failed);
  // Even if they are again those of the frame shown: another one may be on its way.
  connect(&quality_, &FrameQuality::settings_changed, this,
          [this] { frames_.request(frame_request(false)); });
  connect(&quality_, &FrameQuality::failed, this, &Viewport::failed);
  connect(transfer_job_, &TransferJob::made, this, &Viewport::request_frame);
  connect(transfer_job_, &TransferJob::failed, this, &Viewport::failed);
  connect(&document_, &Document::scene_replaced, this, [this] {
    quality_.scene_replaced();
    if (tool_) tool_->abandon();
    if (drag_ == Drag::tool) drag_ = Drag::none;
    hovered_.reset();
    oldest_serial_ = serial_ + 1;
    set_camera(document_.scene().camera);
  });
  connect(&document_, &Document::medium_changed, this, [this] {
    if (tool_) tool_->medium_changed();
    refresh_handles();
    request_frame();
  });
  connect(&document_, &Document::part_changed, this, &Viewport::request_frame);
  connect(&document_, &Document::part_changed, this, &Viewport::update_overlay);
  connect(&document_, &Document::active_emitter_changed, this, &Viewport::update_overlay);
  connect(&document_, &Document::active_light_changed, this, &Viewport::update_overlay);
  connect(&document_, &Document::freedom_changed, this, [this] {
    refresh_handles();
    request_frame();
  });
  connect(&document_, &Document::selection_changed, this, [this] { update_overlay(); });
}

Viewport::~Viewport() = default;

void Viewport::set_camera(const Camera& camera) {
  if (!can_be_stored(camera)) return;
  camera_ = camera;
  refresh_handles();
  request_frame();
}

void Viewport::frame_all() {
  if (const auto sphere = bounding_sphere(document_.scene())) {
    set_camera(frame_sphere(camera_, film(), sphere->center, sphere->radius));
  }
}

void Viewport::frame_selection() {
  if (const auto sphere = bounding_sphere(document_.medium(), document_.selection())) {
    set_camera(frame_sphere(camera_, film(), sphere->center, sphere->radius));
  } else {
    frame_all();
  }
}

void Viewport::set_tool(Tool* tool) {
  if (tool_) {
    if (drag_ == Drag::tool) tool_->cancel();
    tool_->leave();
  }
  if (drag_ == Drag::tool) drag_ = Drag::none;
  tool_ = tool;
  setCursor(tool_ ? tool_->cursor() : Qt::ArrowCursor);
  if (tool_ && underMouse()) tool_->hover(mapFromGlobal(QCursor::pos()));
  update_overlay();
}

glm::dvec3 Viewport::pivot() const {
  const auto sphere = bounding_sphere(document_.medium(), document_.selection());
  return sphere ? sphere->center : camera_.target;
}

glm::dvec3 Viewport::place_under_mouse() const {
  if (!underMouse()) return camera_.target;
  const CameraRays view = rays();
  const QPointF at = mapFromGlobal(QPointF(QCursor::pos()));
  const glm::dvec3 direction = view.direction(at.x(), at.y());
  const double depth = glm::dot(camera_.target - view.eye(), view.forward());
  return view.eye() + direction * (depth / glm::dot(direction, view.forward()));
}

glm::dvec3 Viewport::shift_on_film(QPointF pixels) const {
  const QPointF middle = QRectF(rect()).center();
  return dragged_across(pivot(), rays(), middle, middle + pixels);
}

std::optional<GaussianId> Viewport::most_visible(QPointF position) {
  const CameraRays view = rays();
  const glm::dvec3 direction = view.direction(position.x(), position.y());
  const auto surface = surfaces_.hit(view.eye(), direction);
  const double distance = surface ? glm::distance(surface->position, view.eye())
                                  : std::numeric_limits<double>::infinity();
  const auto scene = document_.visible_snapshot();
  for (const Contribution& met :
       contributions(scene->medium, view.eye(), direction, distance, least_depth)) {
    const GaussianId id = scene->medium.ids()[met.index];
    if (document_.is_free(id)) return id;
  }
  return std::nullopt;
}

void Viewport::set_exposure(double stops) {
  exposure_ = stops;
  show_picture();
}

void Viewport::set_mode(ViewMode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  show_picture();
  update_overlay();
  Q_EMIT mode_changed();
}

// The frame on screen, as it is to be seen now.
void Viewport::show_picture() {
  if (!shown_) return;
  const FrameRequest& request = shown_->request;
  surface_->show_picture(request.exposure == exposure_ && request.mode == mode_
                             ? shown_->picture
                             : to_picture(shown_->frame, exposure_, mode_));
}

Film Viewport::film() const {
  return {std::max(1, width()), std::max(1, height())};
}

void Viewport::set_hovered(std::optional<GaussianId> id) {
  if (id == hovered_) return;
  hovered_ = id;
  update_overlay();
}

void Viewport::show_band(const QRect& rectangle) {
  band_.setVisible(!rectangle.isNull());
  if (!rectangle.isNull()) band_.setGeometry(rectangle);
}

bool Viewport::is_settled() const {
  return shown_ && shown_->request.serial == serial_ && shown_->divisor == 1 &&
         shown_->request.settings == quality_.settings();
}

void Viewport::set_time(double time) {
  if (time == time_) return;
  time_ = time;
  at_time_of_.reset();
  quality_.set_time(time);
  request_frame();
}

std::shared_ptr<const Scene> Viewport::shown_scene() const {
  auto scene = document_.visible_snapshot();
  if (scene->emitters.empty()) return scene;
  if (at_time_of_ != scene) {
    at_time_ = std::make_shared<const Scene>(at_time(*scene, time_));
    at_time_of_ = std::move(scene);
  }
  return at_time_;
}

QString Viewport::gl_problem() const {
  return surface_->gl_problem();
}

FrameRequest Viewport::frame_request(bool moving) const {
  const auto scene = shown_scene();
  const Settings rest = quality_.settings();
  Settings settings = rest;
  if (moving) {
    settings = sliced_settings(rest, motion_slices);
    settings.airlight = rest.airlight;
    if (scene == rested_scene_) {
      // What was prepared for them: going back and forth between two would do it anew each time.
      settings.light_table = rest.light_table;
      settings.shadow_cells = rest.shadow_cells;
      settings.depth_error = rest.depth_error;
    }
  }
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  return {.scene = scene,
          .camera = camera_,
          .film = {std::max(1, pixels.width()), std::max(1, pixels.height())},
          .settings = settings,
          .exposure = exposure_,
          .mode = mode_,
          .serial = serial_,
          .moving = moving};
}

// Everything that changes the picture comes here: something soon, the full frame once it rests.
void Viewport::request_frame() {
  ++serial_;
  quality_.picture_changes(*shown_scene(), camera_);
  transfer_job_->follow(document_.scene());
  frames_.request(frame_request(true));
  rest_timer_.start(rest_after);
}

void Viewport::request_at_rest() {
  if (!is_settled()) frames_.request(frame_request(false));
}

void Viewport::take_frame(std::shared_ptr<const RenderedFrame> frame) {
  if (frame->request.serial < oldest_serial_) return;
  shown_ = std::move(frame);
  show_picture();
  handles_.judge_depth(document_.medium(), {shown_->request.camera, shown_->frame.film},
                       shown_->frame);
  update_overlay();
  if (!shown_->request.moving) rested_scene_ = shown_->request.scene;
  if (is_settled()) quality_.frame_shown(shown_);
  Q_EMIT frame_shown();
}

void Viewport::refresh_handles() {
  handles_.project(document_.medium(), rays(), document_.hidden(), document_.locked());
  update_overlay();
}

void Viewport::draw_overlay() {
  Overlay overlay;
  const CameraRays view = rays();
  handles_.draw(overlay, document_.medium(), view, document_.selection(), hovered_,
                !tool_ || tool_->shows_handles());
  if (mode_ == ViewMode::outlines) handles_.draw_outlines(overlay, document_.medium(), view);
  if (tool_) tool_->draw(overlay, view);
  add_axes(overlay, view, film());
  surface_->show_overlay(overlay);
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  refresh_handles();
  request_frame();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  if (drag_ != Drag::none) return;  // one gesture at a time
  last_position_ = event->position();
  const bool alt = event->modifiers().testFlag(Qt::AltModifier);
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  if (event->button() == Qt::MiddleButton) {
    drag_ = alt || shift ? Drag::pan : Drag::orbit;
  } else if (event->button() == Qt::LeftButton && alt && !(tool_ && tool_->takes_alt())) {
    drag_ = Drag::orbit;
  } else if (event->button() == Qt::RightButton && alt) {
    drag_ = Drag::zoom;
  } else if (event->button() == Qt::LeftButton && tool_) {
    drag_ = Drag::tool;
    tool_->press(event->position(), event->modifiers());
  }
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  const QPointF step = event->position() - last_position_;
  last_position_ = event->position();
  const double half_turn = std::numbers::pi / std::max(1, height());
  switch (drag_) {
    case Drag::none:
      if (tool_) tool_->hover(event->position());
      break;
    case Drag::tool:
      tool_->move(event->position());
      break;
    case Drag::orbit:
      set_camera(orbit(camera_, {step.x() * half_turn, step.y() * half_turn}));
      break;
    case Drag::pan:
      set_camera(pan(camera_, film(), {step.x(), step.y()}));
      break;
    case Drag::zoom:
      set_camera(zoom(camera_, std::exp(0.005 * (step.y() - step.x()))));
      break;
  }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  const Qt::MouseButtons held = event->buttons();
  if (drag_ == Drag::tool && !held.testFlag(Qt::LeftButton)) {
    tool_->release(event->position());
    drag_ = Drag::none;
  } else if (held == Qt::NoButton) {
    drag_ = Drag::none;
  }
}

void Viewport::wheelEvent(QWheelEvent* event) {
  set_camera(zoom(camera_, std::pow(0.999, event->angleDelta().y())));
  event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && drag_ == Drag::tool) {
    tool_->cancel();
  } else {
    QWidget::keyPressEvent(event);
  }
}

void Viewport::leaveEvent(QEvent* /*event*/) {
  if (tool_) tool_->leave();
}

}  // namespace brume
