#include "app/viewport/viewport.h"

#include <QMouseEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "app/document/document.h"
#include "app/viewport/bounds.h"
#include "app/viewport/gizmo.h"
#include "app/viewport/legend.h"
#include "app/viewport/tool.h"
#include "app/viewport/viewport_surface.h"
#include "core/authoring/contribution.h"
#include "core/number_domain.h"
#include "core/scene/at_time.h"
#include "render/settings.h"

namespace brume {
namespace {

constexpr int rest_after = 150;  // milliseconds without a change
constexpr int motion_slices = 8;
constexpr double min_depth = 0.02;  // optical depth of a Gaussian that can be pointed at

bool can_be_stored(const Camera& camera) {
  for (int k = 0; k < 3; ++k) {
    if (!domain::coordinate.contains(camera.eye[k])) return false;
    if (!domain::coordinate.contains(camera.target[k])) return false;
  }
  return camera.eye != camera.target;
}

}  // namespace

Viewport::Viewport(Document& document, ViewServices& services, Projection projection,
                   QWidget* parent)
    : QWidget(parent),
      document_(document),
      services_(services),
      projection_(projection),
      surface_(services.screens.create(this)),
      input_(*this),
      band_(QRubberBand::Rectangle, this),
      legend_(new Legend(this)),
      camera_(document.scene().camera) {
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

  connect(&input_, &ViewInput::pointed_at, this, &Viewport::pointed_at);
  connect(&services_.frames, &FrameService::frame_ready, this, &Viewport::use_frame);
  // Even if they are again those of the frame shown: another one may be on its way.
  connect(&quality_, &FrameQuality::settings_changed, this, [this] {
    if (!isHidden()) services_.frames.request(frame_request(false));
  });
  connect(&quality_, &FrameQuality::failed, this, &Viewport::failed);
  connect(&quality_, &FrameQuality::error_changed, this, &Viewport::map_error);
  connect(&services_.error_mapper, &ErrorMapper::grown, this,
          [this](const auto& frame, const auto& map) {
            if (frame != shown_ || mode_ != ViewMode::error) return;
            error_map_ = map;
            show_picture();
          });
  connect(&services_.error_mapper, &ErrorMapper::failed, this, [this](const QString& message) {
    if (active_) Q_EMIT failed(message);
  });
  connect(&services_.transfer_job, &TransferJob::made, this, &Viewport::request_frame);
  connect(&services_.frames, &FrameService::backend_changed, this, &Viewport::request_frame);
  connect(&document_, &Document::scene_replaced, this, [this] {
    quality_.scene_replaced();
    input_.end_gesture();
    hovered_.reset();
    oldest_serial_ = serial_ + 1;
    reset_camera();
  });
  connect(&document_, &Document::medium_changed, this, [this] {
    refresh_handles();
    request_frame();
  });
  connect(&document_, &Document::part_changed, this, &Viewport::request_frame);
  connect(&document_, &Document::part_changed, this, &Viewport::update_overlay);
  connect(&document_, &Document::active_emitter_changed, this, &Viewport::update_overlay);
  connect(&document_, &Document::active_light_changed, this, &Viewport::update_overlay);
  connect(&document_, &Document::hidden_or_locked_changed, this, [this] {
    refresh_handles();
    request_frame();
  });
  connect(&document_, &Document::selection_changed, this, [this] { update_overlay(); });
  if (projection_ != Projection::perspective) reset_camera();
}

Viewport::~Viewport() = default;

void Viewport::set_camera(const Camera& camera) {
  if (!can_be_stored(camera)) return;
  camera_ = camera;
  refresh_handles();
  request_frame();
}

double Viewport::distance() const {
  if (projection_ == Projection::perspective) return target_distance(camera_);
  return half_height(camera_) / std::tan(0.5 * glm::radians(Camera{}.vertical_fov));
}

void Viewport::reset_camera() {
  if (projection_ == Projection::perspective) {
    set_camera(document_.scene().camera);
  } else {
    // The fog, which a large floor would make small.
    auto sphere = bounding_sphere(document_.medium(), document_.medium().ids());
    if (!sphere) sphere = bounding_sphere(document_.scene());
    frame(sphere.value_or(Sphere{glm::dvec3(0.0), 1.0}));
  }
}

void Viewport::frame(const Sphere& sphere) {
  if (projection_ == Projection::perspective) {
    set_camera(frame_sphere(camera_, film(), sphere.center, sphere.radius));
    return;
  }
  const double aspect = static_cast<double>(film().height) / film().width;
  set_camera(axis_camera(projection_, sphere.center, sphere.radius * std::max(1.0, aspect),
                         bounding_sphere(document_.scene()).value_or(sphere)));
}

void Viewport::zoom_by(double factor) {
  if (projection_ == Projection::perspective) {
    set_camera(zoom(camera_, factor));
    return;
  }
  const Sphere around = bounding_sphere(document_.scene()).value_or(Sphere{camera_.target, 1.0});
  const double half =
      std::clamp(factor * half_height(camera_), 1e-5 * around.radius, 1e3 * around.radius);
  set_camera(axis_camera(projection_, camera_.target, half, around));
}

void Viewport::frame_all() {
  if (const auto sphere = bounding_sphere(document_.scene())) frame(*sphere);
}

void Viewport::frame_selection() {
  if (const auto sphere = bounding_sphere(document_.medium(), document_.selection())) {
    frame(*sphere);
  } else {
    frame_all();
  }
}

void Viewport::set_active(bool active) {
  if (active == active_) return;
  active_ = active;
  if (active) {
    services_.frames.set_active(static_cast<int>(projection_));
    if (is_settled()) measure();
  } else {
    quality_.stop_measuring();
    if (mode_ == ViewMode::error) services_.error_mapper.cancel();
  }
}

void Viewport::set_tool(Tool* tool) {
  if (input_.tool()) input_.tool()->disconnect(this);
  input_.set_tool(tool);
  setCursor(tool ? tool->cursor() : Qt::ArrowCursor);
  if (tool) {
    connect(tool, &Tool::appearance_changed, this, &Viewport::update_overlay);
    if (underMouse()) {
      tool->set_view(*this);
      tool->hover(mapFromGlobal(QCursor::pos()));
    }
  }
  update_overlay();
}

glm::dvec3 Viewport::pivot() const {
  const auto sphere = bounding_sphere(document_.medium(), document_.selection());
  return sphere ? sphere->center : camera_.target;
}

glm::dvec3 Viewport::place_under_mouse(double radius) {
  const CameraRays view = rays();
  const QPointF at =
      underMouse() ? mapFromGlobal(QPointF(QCursor::pos())) : 0.5 * QPointF(width(), height());
  const glm::dvec3 direction = view.direction(at.x(), at.y());
  const double depth = glm::dot(camera_.target - view.eye(), view.forward());
  double distance = depth / glm::dot(direction, view.forward());
  if (const auto surface = services_.surfaces.hit(view.eye(), direction)) {
    const double there = glm::distance(surface->position, view.eye());
    // The sphere touches the surface, but moves at most half way to the eye.
    const double back = radius / std::abs(glm::dot(direction, surface->normal));
    distance = std::min(distance, std::max(there - back, 0.5 * there));
  }
  return view.eye() + distance * direction;
}

glm::dvec3 Viewport::shift_on_film(QPointF pixels) const {
  const QPointF middle = QRectF(rect()).center();
  return dragged_across(pivot(), rays(), middle, middle + pixels);
}

std::optional<GaussianId> Viewport::max_visible(QPointF position) {
  const CameraRays view = rays();
  const glm::dvec3 direction = view.direction(position.x(), position.y());
  const auto surface = services_.surfaces.hit(view.eye(), direction);
  const double distance = surface ? glm::distance(surface->position, view.eye())
                                  : std::numeric_limits<double>::infinity();
  const auto scene = document_.visible_snapshot();
  for (const Contribution& met :
       contributions(scene->medium, view.eye(), direction, distance, min_depth)) {
    const GaussianId id = scene->medium.ids()[met.index];
    if (document_.is_editable(id)) return id;
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
  forget_error_map();
  show_picture();
  map_error();
  update_overlay();
  Q_EMIT mode_changed();
}

// The frame on screen, as it is to be seen now.
void Viewport::show_picture() {
  if (!shown_) return;
  const FrameRequest& request = shown_->request;
  const bool as_made = request.exposure == exposure_ && request.mode == mode_;
  if (shown_->on_device && !as_made) return;  // the one at rest, which is to come, will be as asked
  legend_->show_scale(color_scale(shown_->frame, mode_, error_map_.get()));
  place_legend();
  if (error_map_) {
    surface_->show_picture(error_picture(*error_map_));
  } else if (shown_->on_device) {
    surface_->show_picture(shown_->on_device);
  } else {
    surface_->show_picture(as_made ? shown_->picture : to_picture(shown_->frame, exposure_, mode_));
  }
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
         !shown_->on_device && shown_->request.settings == quality_.settings();
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
  const bool is_clear =
      projection_ == Projection::perspective || scene->medium.homogeneous_density() == 0.0;
  if (!is_animated(*scene) && is_clear) return scene;
  if (at_time_of_ != scene) {
    Scene shown = evaluate_at(*scene, time_);
    if (!is_clear) shown.medium.set_homogeneous_density(0.0);
    at_time_ = std::make_shared<const Scene>(std::move(shown));
    at_time_of_ = std::move(scene);
  }
  return at_time_;
}

bool Viewport::shows_handles() const {
  return !input_.tool() || input_.tool()->shows_handles();
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
    settings.patch_light_tables = true;
    if (scene == rested_scene_) {
      // Keeps prepared data: alternating between two would rebuild it each time.
      settings.optical_depth_table = rest.optical_depth_table;
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
          .view = static_cast<int>(projection_),
          .serial = serial_,
          .moving = moving,
          .depth = !document_.selection().empty() || shows_handles()};
}

// Everything that changes the picture comes here: something soon, the full frame once it rests.
void Viewport::request_frame() {
  ++serial_;
  forget_error_map();
  if (isHidden()) return;
  quality_.picture_changes(*shown_scene(), camera_);
  services_.transfer_job.follow(document_.scene());
  services_.frames.request(frame_request(true));
  rest_timer_.start(rest_after);
}

void Viewport::request_at_rest() {
  if (!is_settled() && !isHidden()) services_.frames.request(frame_request(false));
}

void Viewport::use_frame(const std::shared_ptr<const RenderedFrame>& frame) {
  if (frame->request.view != static_cast<int>(projection_)) return;
  if (frame->request.serial < oldest_serial_) return;
  shown_ = frame;
  forget_error_map();
  show_picture();
  handles_.classify_depth(document_.medium(), {shown_->request.camera, shown_->frame.film},
                          shown_->frame);
  update_overlay();
  if (!shown_->request.moving) rested_scene_ = shown_->request.scene;
  if (is_settled()) measure();
  Q_EMIT frame_shown();
}

// One view at a time: each measurement takes all cores.
void Viewport::measure() {
  if (active_) quality_.frame_shown(shown_);
}

// Once the frame is measured, auto will not choose another.
void Viewport::map_error() {
  if (mode_ == ViewMode::error && active_ && is_measured()) services_.error_mapper.start(shown_);
}

void Viewport::forget_error_map() {
  if (active_) services_.error_mapper.cancel();
  error_map_.reset();
}

void Viewport::place_legend() {
  legend_->move(width() - legend_->width() - 8, height() - legend_->height() - 8);
}

void Viewport::refresh_handles() {
  handles_.project(document_.medium(), rays(), document_.hidden(), document_.locked());
  update_overlay();
}

void Viewport::draw_overlay() {
  Overlay overlay;
  const CameraRays view = rays();
  handles_.draw(overlay, document_.medium(), view, document_.selection(), hovered_,
                shows_handles());
  if (mode_ == ViewMode::outlines) handles_.draw_outlines(overlay, document_.medium(), view);
  if (const Tool* tool = input_.tool()) {
    tool->draw(overlay, view);
    if (&tool->view() == this) tool->draw_on_film(overlay);
  }
  add_axes(overlay, view, film());
  surface_->show_overlay(overlay);
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_legend();
  refresh_handles();
  request_frame();
}

void Viewport::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh_handles();
  if (!is_settled()) request_frame();
}

void Viewport::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (isHidden()) services_.frames.forget(static_cast<int>(projection_));
}

void Viewport::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  Q_EMIT used();
}

void Viewport::enterEvent(QEnterEvent* /*event*/) {
  input_.enter();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  Q_EMIT used();
  input_.press(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  input_.move(event->position());
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  input_.release(*event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
  Q_EMIT used();
  input_.flush_moves();  // it was meant for the view as it was
  zoom_by(std::pow(0.999, event->angleDelta().y()));
  event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !input_.cancel()) QWidget::keyPressEvent(event);
}

void Viewport::leaveEvent(QEvent* /*event*/) {
  input_.leave();
}

}  // namespace brume
