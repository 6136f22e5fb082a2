#include "app/view/view.h"
#include "core/scene/camera_rays.h"

#include <QCursor>
#include <QWidget>
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "app/document/document.h"
#include "app/document/time/scene_at.h"
#include "app/view/camera/bounds.h"
#include "app/view/camera/object_box.h"
#include "app/view/drawing/gizmo.h"
#include "app/view/paint_point.h"
#include "app/view/surface_picker.h"
#include "brume/at_time.h"
#include "core/authoring/contribution.h"
#include "core/transport/optical_depth.h"
#include "render/prepare/fog_extent.h"

namespace brume {

View::View(const Document& document, SurfacePicker& surfaces, Projection projection,
           const QWidget& pane)
    : document_(document),
      surfaces_(surfaces),
      pane_(pane),
      camera_(document, surfaces, projection, pane),
      handles_(document, camera_) {}

void View::set_time(double time) {
  time_ = time;
  at_time_of_.reset();
}

std::shared_ptr<const Scene> View::shown_scene() const {
  auto scene = document_.visible_snapshot();
  const bool is_clear =
      projection() == Projection::perspective || scene->medium.homogeneous_density() == 0.0;
  const bool has_sky = scene->environment && scene->environment->sky;
  if (!is_animated(*scene) && !has_sky && is_clear) return scene;
  if (at_time_of_ != scene) {
    problem_.clear();
    Scene shown = scene_at(*scene, time_, problem_);
    if (!is_clear) shown.medium.set_homogeneous_density(0.0);
    // A medium that stays the same stays the same revision: nothing made from it is made again.
    if (at_time_of_ && at_time_->time == time_ &&
        at_time_of_->medium.revision() == scene->medium.revision() &&
        at_time_of_->emitters == scene->emitters && at_time_of_->sequences == scene->sequences) {
      shown.medium = at_time_->medium;
    }
    at_time_ = std::make_shared<const Scene>(std::move(shown));
    at_time_of_ = std::move(scene);
  }
  return at_time_;
}

glm::dvec3 View::pivot() const {
  if (const auto& object = document_.object()) {
    return object_center(document_.scene(), *object, rays());
  }
  const auto sphere = bounding_sphere(document_.medium(), document_.selection());
  return sphere ? sphere->center : camera().target;
}

QPointF View::mouse_position() const {
  if (menu_) return asked_;
  return pane_.underMouse() ? pane_.mapFromGlobal(QPointF(QCursor::pos()))
                            : QRectF(pane_.rect()).center();
}

void View::set_asked(const QObject& menu, QPointF position) {
  menu_ = &menu;
  asked_ = position;
}

glm::dvec3 View::place_under_mouse(double radius) {
  const auto point = paint_point(*this, {.stands = true}, mouse_position(), radius);
  return point ? point->position : camera().target;
}

std::optional<glm::dvec3> View::point_under(QPointF position) {
  constexpr double far = 4.0;  // times the distance of the target
  const CameraRays view = rays();
  const glm::dvec3 origin = view.origin(position.x(), position.y());
  const glm::dvec3 direction = view.direction(position.x(), position.y());
  const auto surface = surfaces_.hit_in_view(view, origin, direction);
  const auto distance = surface ? std::optional(glm::distance(origin, surface->position))
                                : fog_on(origin, direction).middle_of_gaussians(min_pointed_effect);
  if (!distance || *distance > far * target_distance(camera())) return std::nullopt;
  return origin + *distance * direction;
}

FogOnRay View::fog_on(const glm::dvec3& origin, const glm::dvec3& direction) const {
  const auto scene = shown_scene();
  const FogInterval in_fog = fog_of(*scene).interval(origin, direction);
  return {*scene, origin, direction, {in_fog.begin, in_fog.end}};
}

glm::dvec3 View::shift_on_film(QPointF pixels) const {
  const QPointF middle = QRectF(pane_.rect()).center();
  return dragged_across(pivot(), rays(), middle, middle + pixels);
}

std::optional<std::size_t> View::visible_surface(QPointF position) {
  const CameraRays view = rays();
  const glm::dvec3 origin = view.origin(position.x(), position.y());
  const glm::dvec3 direction = view.direction(position.x(), position.y());
  const auto surface = surfaces_.hit_in_view(view, origin, direction);
  if (!surface) return std::nullopt;
  const std::size_t index = surfaces_.index_of(*surface);
  if (document_.scene().surfaces[index].locked) return std::nullopt;
  const double depth =
      fog_on(origin, direction).optical_depth(glm::distance(origin, surface->position));
  return depth < std::numbers::ln2 ? std::optional(index) : std::nullopt;
}

std::optional<std::size_t> View::surface_at_eye() const {
  constexpr double near = 0.03;  // times the distance of the target
  if (camera_.leaves_out_walls()) return std::nullopt;
  const CameraRays view = rays();
  std::optional<SurfacePoint> hit;
  for (const double y : {0.2, 0.8, 0.5}) {
    for (const double x : {0.2, 0.8, 0.5}) {
      const glm::dvec3 origin = view.origin(x * film().width, y * film().height);
      hit = surfaces_.hit(origin, view.direction(x * film().width, y * film().height));
      const bool is_near =
          hit && glm::distance(origin, hit->position) < near * target_distance(camera());
      if (!is_near) return std::nullopt;
    }
  }
  return surfaces_.index_of(*hit);
}

std::optional<GaussianId> View::max_visible(QPointF position) {
  const CameraRays view = rays();
  const glm::dvec3 origin = view.origin(position.x(), position.y());
  const glm::dvec3 direction = view.direction(position.x(), position.y());
  const auto surface = surfaces_.hit_in_view(view, origin, direction);
  const double distance =
      surface ? glm::distance(surface->position, origin) : std::numeric_limits<double>::infinity();
  const auto scene = document_.visible_snapshot();
  const FogInterval in_fog = fog_of(*scene).interval(origin, direction);
  for (const Contribution& met :
       contributions(scene->medium, scene->optics.albedo, origin, direction, distance,
                     min_pointed_effect, {in_fog.begin, in_fog.end})) {
    const GaussianId id = scene->medium.ids()[met.index];
    if (document_.is_editable(id)) return id;
  }
  return std::nullopt;
}

}  // namespace brume
