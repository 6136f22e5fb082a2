#include "app/tools/selection/sun_handle.h"

#include <QLineF>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/commands/objects/edit_environment.h"
#include "app/document/document.h"
#include "app/view/drawing/overlay.h"
#include "app/widgets/interface_settings.h"
#include "core/scene/lights/sky.h"

namespace brume {
namespace {

constexpr double sun_size = 6.0;  // pixels, at a scale of the handles of 1
constexpr QRgb sky_sun_color = qRgba(255, 232, 170, 230);

}  // namespace

double sun_radius() {
  return sun_size * handle_scale();
}

void draw_sun_icon(Overlay& overlay, QPointF place, QRgb color, bool hovered) {
  overlay.add_circle(place.x(), place.y(), sun_radius(), color);
  for (int ray = 0; ray < 8; ++ray) {
    const double angle = glm::two_pi<double>() * ray / 8;
    const auto point = [&](double radius) {
      return Overlay::Vertex{static_cast<float>(place.x() + radius * std::cos(angle)),
                             static_cast<float>(place.y() + radius * std::sin(angle)), color};
    };
    overlay.lines.push_back(point(sun_radius() + 2.0));
    overlay.lines.push_back(point(sun_radius() + (hovered ? 7.0 : 5.0)));
  }
}

std::optional<glm::dvec3> SunHandle::direction() const {
  const auto& environment = document_.scene().environment;
  if (!environment || !environment->sky) return std::nullopt;
  return direction_to_sun(*environment, *environment->sky);
}

std::optional<QPointF> SunHandle::place(const CameraRays& rays) const {
  const auto to_sun = direction();
  if (!to_sun || rays.is_parallel()) return std::nullopt;
  // So near to the eye that its distance costs no digits.
  const glm::dvec3 projected = rays.project(rays.eye() + (1.0 + glm::length(rays.eye())) * *to_sun);
  return projected.z > 0.0 ? std::optional(QPointF(projected.x, projected.y)) : std::nullopt;
}

bool SunHandle::hover(const CameraRays& rays, QPointF position) {
  const auto sun = place(rays);
  is_hovered_ = sun && QLineF(*sun, position).length() <= sun_radius() + 3.0;
  return is_hovered_;
}

bool SunHandle::press(const CameraRays& rays, QPointF position) {
  if (!hover(rays, position)) return false;
  gesture_ = {*place(rays) - position, document_.scene().environment.value(), new_merge_id()};
  return true;
}

void SunHandle::move(const CameraRays& rays, QPointF position) {
  if (!direction()) return;  // undo works during a drag, too
  const QPointF sun = position + gesture_->offset;
  move_sun(document_, rays.direction(sun.x(), sun.y()), gesture_->merge_id);
}

void SunHandle::cancel() {
  if (direction()) put_back_environment(document_, gesture_->before, gesture_->merge_id);
  gesture_.reset();
}

void SunHandle::draw(Overlay& overlay, const CameraRays& rays) const {
  if (const auto sun = place(rays)) draw_sun_icon(overlay, *sun, sky_sun_color, is_hovered_);
}

}  // namespace brume
