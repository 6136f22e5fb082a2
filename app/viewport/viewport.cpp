#include "app/viewport/viewport.h"

#include <QMouseEvent>
#include <QTabletEvent>
#include <QVBoxLayout>

#include "app/document/document.h"
#include "app/document/object_titles.h"
#include "app/view/drawing/camera_outline.h"
#include "app/view/drawing/ground_grid.h"
#include "app/view/tool.h"
#include "app/viewport/camera_frame.h"
#include "app/viewport/legend.h"
#include "app/viewport/view_services.h"
#include "app/widgets/interface_settings.h"
#include "render/prepare/fog_extent.h"

namespace brume {
namespace {

// The outline of homogeneous fog is faint.
constexpr QRgb fog_outline_color = qRgba(200, 205, 215, 70);

}  // namespace

Viewport::Viewport(Document& document, ViewServices& services, Projection projection,
                   QWidget* parent)
    : QWidget(parent),
      View(document, services.surfaces, projection, *this),
      document_(document),
      surface_(services.screens.create(this)),
      frames_(document, services.frames, *this, *this),
      input_(*this),
      band_(QRubberBand::Rectangle, this),
      camera_frame_(new CameraFrame(this)),
      legend_(new Legend(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(surface_->widget());
  surface_->widget()->setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);

  overlay_timer_.setSingleShot(true);
  connect(&overlay_timer_, &QTimer::timeout, this, &Viewport::draw_overlay);
  connect(&input_, &ViewInput::pointed_at, this, &Viewport::pointed_at);
  connect(&input_, &ViewInput::menu_asked, this, &Viewport::menu_asked);
  connect(&camera_controller(), &CameraController::moved, &frames_, &FrameScheduler::change_look);
  connect(&camera_controller(), &CameraController::moved, this, &Viewport::show_camera_frame);
  connect(camera_frame_, &CameraFrame::plate_behind_changed, &frames_, &FrameScheduler::set_plate);
  connect(&shown_handles(), &ShownHandles::changed, this, &Viewport::update_overlay);
  connect(&frames_, &FrameScheduler::frame_shown, this, [this] {
    show_picture();
    const RenderedFrame& frame = *frames_.shown();
    if (!frame.cached) shown_handles().set_depth(frame.request.camera, frame.frame);
  });
  connect(&frames_, &FrameScheduler::picture_changed, this, &Viewport::show_picture);
  connect(&frames_, &FrameScheduler::mode_changed, this, &Viewport::update_overlay);
  on_change(document, Change::scene, this, [this] {
    input_.end_gesture();
    camera_controller().reset();
    frames_.set_exposure(0.0);
  });
  on_change(document, Change::part | Change::active_emitter | Change::active_light | Change::object,
            this, &Viewport::update_overlay);
  on_change(document, Change::part, this, &Viewport::show_camera_frame);
  connect(&InterfaceSettings::instance(), &InterfaceSettings::changed, this,
          &Viewport::update_overlay);
  if (projection != Projection::perspective) camera_controller().reset();
}

Viewport::~Viewport() = default;

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
  shown_handles().show_centers(!tool || tool->shows_handles());
}

void Viewport::show_overlay(bool shown) {
  shows_overlay_ = shown;
  update_overlay();
}

void Viewport::set_time(double time) {
  if (time == View::time()) return;
  View::set_time(time);
  frames_.request();
}

void Viewport::show_band(const QRect& rectangle) {
  band_.setVisible(!rectangle.isNull());
  if (!rectangle.isNull()) band_.setGeometry(rectangle);
}

QString Viewport::camera_title() const {
  const bool is_through = camera() == document_.scene().camera;
  return is_through ? QString::fromStdString(document_.scene().camera_name) : tr("Free View");
}

QString Viewport::gl_problem() const {
  return surface_->gl_problem();
}

void Viewport::show_ground_grid(bool shown) {
  ground_grid_ = shown;
  update_overlay();
}

// The frame on screen, as it is to be seen now.
void Viewport::show_picture() {
  const RenderedFrame* frame = frames_.shown();
  if (!frame) return;
  const DisplayLook display = frames_.display();
  const ViewMode mode = frames_.mode();
  const bool as_made = frame->request.display == display && frame->request.mode == mode;
  // The one at rest, which is to come, will be as asked.
  if ((frame->on_device || frame->cached) && !as_made) return;
  const ErrorMap* error_map = frames_.error_map();
  ColorScale scale = color_scale(frame->frame, mode, error_map);
  QStringList notes;
  if (!scale.title.isEmpty()) notes << scale.title;
  if (frame->request.headlight && scale.ticks.isEmpty()) {
    notes << tr("Nothing lights this scene: shown by a headlight");
  }
  if (frame->request.camera.clip != Camera().clip) notes << tr("Without the walls before the room");
  if (const auto surface = frame->request.moving ? std::nullopt : surface_at_eye()) {
    const QStringList names = surface_names(document_.scene().surfaces);
    notes << tr("%1 is right before the eye, as if inside it; Home shows all")
                 .arg(names.value(static_cast<int>(*surface)));
  }
  scale.title = notes.join(" · ");
  legend_->show_scale(scale);
  place_legend();
  if (error_map) {
    surface_->show_picture(error_picture(*error_map));
  } else if (frame->on_device) {
    surface_->show_picture(frame->on_device);
  } else {
    surface_->show_picture(as_made ? frame->picture : to_picture(frame->frame, display, mode));
  }
}

void Viewport::place_legend() {
  legend_->move(width() - legend_->width() - 8, height() - legend_->height() - 8);
}

void Viewport::show_camera_frame() {
  const QString name = QString::fromStdString(document_.scene().camera_name);
  const Film& film = document_.scene().film;
  camera_frame_->show_frame(camera_controller().frame(),
                            tr("%1 · %2 × %3").arg(name).arg(film.width).arg(film.height));
}

const FogBall& Viewport::fog_ball() {
  // Parallel views render without it.
  const bool has_fog = projection() == Projection::perspective;
  auto scene = has_fog ? shown_scene() : document_.visible_snapshot();
  if (scene != fog_ball_of_) {
    fog_ball_ = fog_of(*scene);
    fog_ball_of_ = std::move(scene);
  }
  return fog_ball_;
}

void Viewport::draw_overlay() {
  Overlay overlay;
  if (!shows_overlay_) return surface_->show_overlay(overlay);
  if (ground_grid_) {
    std::optional<GridDepth> depth;
    if (const RenderedFrame* frame = frames_.shown()) {
      depth.emplace(GridDepth{frame->frame, frame->request.camera});
    }
    add_ground_grid(overlay, camera(), film(), distance(), depth);
  }
  shown_handles().draw(overlay);
  if (frames_.mode() == ViewMode::outlines) shown_handles().draw_outlines(overlay);
  if (const Tool* tool = input_.tool()) {
    tool->draw(overlay, rays());
    if (&tool->view() == this) tool->draw_on_film(overlay);
  }
  // The perspective view looks through it, or came from there.
  if (projection() != Projection::perspective) {
    add_camera_outline(overlay, rays(), document_.scene().camera, document_.scene().film);
  }
  if (const FogBall& fog = fog_ball(); !fog.is_endless()) {
    overlay.add_outline(rays(), {fog.center, fog.radius, 1.0}, fog_outline_color);
  }
  add_axes(overlay, rays(), film());
  surface_->show_overlay(overlay);
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_legend();
  show_camera_frame();
  shown_handles().project();
  frames_.request();
}

void Viewport::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  shown_handles().project();
  frames_.resume();
}

void Viewport::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (isHidden()) frames_.forget();
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
  if (event->buttons() == Qt::NoButton) frames_.end_gesture();
}

// Qt sends a pen's events again as those of a mouse if they are ignored; only the pressure is new.
void Viewport::tabletEvent(QTabletEvent* event) {
  input_.set_pen(event->type() != QEvent::TabletRelease, event->pressure());
  event->ignore();
}

void Viewport::wheelEvent(QWheelEvent* event) {
  Q_EMIT used();
  input_.turn_wheel(event->angleDelta().y());
  event->accept();
}

void Viewport::leaveEvent(QEvent* /*event*/) {
  input_.leave();
}

}  // namespace brume
