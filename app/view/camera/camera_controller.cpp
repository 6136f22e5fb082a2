#include "app/view/camera/camera_controller.h"

#include <QWidget>
#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "app/document/document.h"
#include "app/view/camera/bounds.h"
#include "app/view/camera/object_box.h"
#include "app/view/camera/walls.h"
#include "brume/mesh_arrays.h"
#include "core/scene/cameras.h"
#include "core/scene/fields/camera_fields.h"

namespace brume {
namespace {

bool can_be_stored(const Camera& camera) {
  return is_in_domain(camera) && !refusal(camera);
}

}  // namespace

CameraController::CameraController(const Document& document, SurfacePicker& surfaces,
                                   Projection projection, const QWidget& pane)
    : document_(document),
      surfaces_(surfaces),
      projection_(projection),
      pane_(pane),
      camera_(document.scene().camera) {
  on_change(document, Change::part, this, &CameraController::follow_scene);
}

void CameraController::set_camera(const Camera& camera) {
  if (!can_be_stored(camera)) return;
  walls_ = {};
  inside_.reset();
  show(camera);
}

void CameraController::show(const Camera& camera) {
  through_ = false;
  camera_ = camera;
  Q_EMIT moved();
}

void CameraController::navigate_to(const Camera& camera) {
  if (!through_ || !locked_) {
    if (!can_be_stored(camera)) return;
    const Camera inside = inside_.value_or(camera_);
    walls_ = {};
    if (can_fly()) walls_ = walls_before(surfaces_, inside, camera, film());
    inside_ = walls_ == Camera().clip ? std::nullopt : std::optional(inside);
    show(camera);
  } else if (can_be_stored(camera)) {
    Q_EMIT scene_camera_asked_for(camera);
  }
}

void CameraController::look_through_scene_camera() {
  if (projection_ != Projection::perspective) return;
  walls_ = {};
  inside_.reset();
  through_ = true;
  camera_ = document_.scene().camera;
  scene_film_ = document_.scene().film;
  Q_EMIT moved();
}

void CameraController::follow_scene() {
  if (!through_) return;
  const Scene& scene = document_.scene();
  if (scene.camera != camera_ || scene.film != scene_film_) look_through_scene_camera();
}

void CameraController::set_frame_shown(bool shown) {
  shows_frame_ = shown;
  if (through_) Q_EMIT moved();
}

double CameraController::margin() const {
  constexpr double least = 1.08;  // the pane over the frame
  const Film& scene_film = document_.scene().film;
  const double aspect = static_cast<double>(scene_film.width) / scene_film.height;
  const double pane_aspect = static_cast<double>(film().width) / film().height;
  return least * std::max(1.0, aspect / pane_aspect);
}

Camera CameraController::shown_camera() const {
  Camera camera = camera_;
  camera.clip = walls_;
  if (!through_ || !shows_frame_) return camera;
  if (camera.height) {
    camera.height = margin() * *camera.height;
    return camera;
  }
  const double half = std::tan(0.5 * glm::radians(camera_.vertical_fov));
  camera.vertical_fov = 2.0 * glm::degrees(std::atan(margin() * half));
  return camera;
}

std::optional<QRectF> CameraController::frame() const {
  if (!through_ || !shows_frame_) return std::nullopt;
  const Film& scene_film = document_.scene().film;
  const double height = film().height / margin();
  const double width = height * scene_film.width / scene_film.height;
  return QRectF(0.5 * (film().width - width), 0.5 * (film().height - height), width, height);
}

Film CameraController::film() const {
  return {std::max(1, pane_.width()), std::max(1, pane_.height())};
}

double CameraController::distance() const {
  if (projection_ == Projection::perspective && !camera_.height) return target_distance(camera_);
  return half_height(camera_) / std::tan(0.5 * glm::radians(Camera{}.vertical_fov));
}

void CameraController::reset() {
  if (projection_ == Projection::perspective) {
    set_camera(document_.scene().camera);
  } else {
    // The fog, which a large floor would make small.
    auto sphere = bounding_sphere(document_.medium(), document_.medium().ids());
    if (!sphere) sphere = bounding_sphere(document_.scene());
    frame(sphere.value_or(Sphere{glm::dvec3(0.0), 1.0}));
  }
}

void CameraController::frame(const Sphere& sphere) {
  if (projection_ == Projection::perspective) {
    navigate_to(frame_sphere(camera_, film(), sphere.center, sphere.radius));
    return;
  }
  const double aspect = static_cast<double>(film().height) / film().width;
  navigate_to(axis_camera(projection_, sphere.center, sphere.radius * std::max(1.0, aspect),
                          bounding_sphere(document_.scene()).value_or(sphere)));
}

void CameraController::frame_all() {
  if (const auto sphere = bounding_sphere(document_.scene())) frame(*sphere);
}

void CameraController::frame_selection() {
  if (const auto& object = document_.object()) {
    if (object->kind == ObjectRef::Kind::surface) {
      const Surface& surface = document_.scene().surfaces[object->index];
      if (object->node) return frame(bounding_sphere(box_corners(surface, object->node)));
      return frame(bounding_sphere(world_points(surface)));
    }
  }
  if (const auto sphere = bounding_sphere(document_.grouped_medium(), document_.selection())) {
    frame(*sphere);
  } else {
    frame_all();
  }
}

void CameraController::zoom_by(double factor) {
  if (projection_ == Projection::perspective) {
    navigate_to(zoom(camera_, factor));
    return;
  }
  const Sphere around = bounding_sphere(document_.scene()).value_or(Sphere{camera_.target, 1.0});
  const double half =
      std::clamp(factor * half_height(camera_), 1e-5 * around.radius, 1e3 * around.radius);
  navigate_to(axis_camera(projection_, camera_.target, half, around));
}

void CameraController::drag(NavigationDrag drag, QPointF movement) {
  const double half_turn = std::numbers::pi / film().height;
  if (drag == NavigationDrag::zoom) {
    zoom_by(std::exp(0.005 * (movement.y() - movement.x())));
  } else if (drag == NavigationDrag::orbit && projection_ == Projection::perspective) {
    navigate_to(orbit(camera_, pivot_.value_or(camera_.target),
                      {movement.x() * half_turn, movement.y() * half_turn}));
  } else {
    navigate_to(pan(camera_, film(), {movement.x(), movement.y()}));
  }
}

bool CameraController::can_fly() const {
  return projection_ == Projection::perspective && !camera_.height;
}

void CameraController::look_around(QPointF movement) {
  const double per_pixel = glm::radians(camera_.vertical_fov) / film().height;
  navigate_to(orbit(camera_, camera_.eye, {movement.x() * per_pixel, movement.y() * per_pixel}));
}

void CameraController::fly(const glm::dvec3& way) {
  navigate_to(brume::fly(camera_, distance() * way));
}

}  // namespace brume
