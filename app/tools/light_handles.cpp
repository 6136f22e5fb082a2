#include "app/tools/light_handles.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/commands/edit_lights.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/view/gizmo.h"
#include "app/view/overlay.h"
#include "app/widgets/color_button.h"
#include "core/limits.h"

namespace brume {
namespace {

constexpr double sun_radius = 6.0;  // pixels
constexpr double ring_min = 18.0;
constexpr double ring_per_decade = 14.0;
constexpr double pick_distance = 4.0;

double ring_radius(double strength) {
  return ring_min + ring_per_decade * std::log10(1.0 + strength);
}

double strength_of(double radius) {
  const double strength = std::pow(10.0, (radius - ring_min) / ring_per_decade) - 1.0;
  return std::clamp(QString::number(strength, 'g', 4).toDouble(), 0.0, limits::intensity);
}

}  // namespace

std::optional<LightHandles::Handle> LightHandles::pick(const CameraRays& rays,
                                                       QPointF position) const {
  const auto& lights = document_.scene().lights;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const glm::dvec3 at = rays.project(lights[k].position);
    if (at.z <= 0.0) continue;
    const double distance = QLineF(QPointF(at.x, at.y), position).length();
    if (distance <= sun_radius + 3.0) return Handle{k, false};
    const bool ringed = k == document_.active_light();
    if (ringed && std::abs(distance - ring_radius(light_strength(lights[k]))) <= pick_distance) {
      return Handle{k, true};
    }
  }
  return std::nullopt;
}

bool LightHandles::hover(const CameraRays& rays, QPointF position) {
  hovered_ = pick(rays, position);
  return hovered_.has_value();
}

bool LightHandles::press(const CameraRays& rays, QPointF position) {
  const auto handle = pick(rays, position);
  if (!handle) return false;
  document_.set_active_light(handle->light);
  gesture_ = {*handle, position, document_.scene().lights[handle->light], new_merge_id()};
  return true;
}

void LightHandles::move(const CameraRays& rays, QPointF position) {
  const auto [handle, start, before, merge_id] = *gesture_;
  if (handle.is_ring) {
    const glm::dvec3 at = rays.project(before.position);
    const double strength = strength_of(QLineF(QPointF(at.x, at.y), position).length());
    change_light(document_, handle.light, undo_text("Set intensity of %1"), merge_id,
                 [&](PointLight& l) { l.intensity = strength * light_color(before); });
  } else {
    glm::dvec3 place = before.position + dragged_across(before.position, rays, start, position);
    place = glm::clamp(place, -limits::coordinate, limits::coordinate);
    change_light(document_, handle.light, undo_text("Move %1"), merge_id,
                 [&](PointLight& l) { l.position = place; });
  }
}

void LightHandles::cancel() {
  const auto [handle, start, before, merge_id] = *gesture_;
  change_light(document_, handle.light, undo_text("Move %1"), merge_id,
               [&](PointLight& l) { l = before; });
  gesture_.reset();
}

void LightHandles::draw(Overlay& overlay, const CameraRays& rays) const {
  const auto& lights = document_.scene().lights;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const glm::dvec3 at = rays.project(lights[k].position);
    if (at.z <= 0.0) continue;
    const QColor color = to_color(light_color(lights[k]));
    const int alpha = lights[k].on ? 230 : 90;
    const QRgb rgba = qRgba(color.red(), color.green(), color.blue(), alpha);
    const bool hovered = hovered_ && hovered_->light == k;
    overlay.add_circle(at.x, at.y, sun_radius, rgba);
    for (int ray = 0; ray < 8; ++ray) {
      const double angle = glm::two_pi<double>() * ray / 8;
      const auto point = [&](double radius) {
        return Overlay::Vertex{static_cast<float>(at.x + radius * std::cos(angle)),
                               static_cast<float>(at.y + radius * std::sin(angle)), rgba};
      };
      overlay.lines.push_back(point(sun_radius + 2.0));
      overlay.lines.push_back(point(sun_radius + (hovered ? 7.0 : 5.0)));
    }
    if (k == document_.active_light()) {
      const bool bright = hovered && hovered_->is_ring;
      overlay.add_circle(at.x, at.y, ring_radius(light_strength(lights[k])),
                         qRgba(color.red(), color.green(), color.blue(), bright ? 255 : 120));
    }
  }
}

}  // namespace brume
