#include "app/tools/selection/light_handles.h"

#include <QLineF>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "app/commands/objects/edit_lights.h"
#include "app/commands/objects/edit_objects.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/tools/selection/sun_handle.h"
#include "app/view/camera/navigation.h"
#include "app/view/camera/object_box.h"
#include "app/view/drawing/gizmo.h"
#include "app/view/drawing/overlay.h"
#include "app/widgets/color_button.h"
#include "app/widgets/interface_settings.h"
#include "brume/limits.h"
#include "core/math/basis.h"
#include "core/math/infinity.h"
#include "core/math/rounded.h"
#include "core/math/unit_direction.h"
#include "core/overloaded.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"

namespace brume {
namespace {

// In pixels, at a scale of the handles of 1.
constexpr double ring_min = 18.0;
constexpr double ring_per_decade = 14.0;
constexpr double pick_size = 4.0;

double pick_distance() {
  return pick_size * handle_scale();
}

double ring_radius(double strength) {
  return handle_scale() * (ring_min + ring_per_decade * std::log10(1.0 + strength));
}

double strength_of(double radius) {
  const double decades = (radius / handle_scale() - ring_min) / ring_per_decade;
  return std::clamp(rounded(std::pow(10.0, decades) - 1.0, 4), 0.0, limits::intensity);
}

using Part = LightHandles::Handle::Part;

// Whether it has an end of its axis to drag: a directional light is turned by its icon.
bool has_target(const Light& light) {
  return !light.as<light::Directional>() && light_direction(light).has_value();
}

}  // namespace

// The outline of a light besides its icon: the axis, as long as a share of the distance that
// it is seen from, and the rim of its cone or the edge of its surface.
struct LightHandles::DrawnShape {
  glm::dvec3 axis{0.0};    // unit
  double length = 0.0;     // of the axis [u]
  glm::dvec3 target{0.0};  // end of the axis
  double radius = 0.0;     // of a cone's rim, around the target; none of a cone that is too wide
  std::vector<glm::dvec3> outline;  // closed

  DrawnShape(const Light& light, const CameraRays& rays) {
    constexpr double share = 0.2;
    length = share * viewing_distance(rays, light.position);
    const glm::dvec3 to_eye = rays.is_parallel() ? -rays.forward() : rays.eye() - light.position;
    axis = unit_direction(light_direction(light).value_or(to_eye), {0.0, -1.0, 0.0});
    target = light.position + length * axis;
    std::visit(Overloaded{[](const light::Point&) {}, [](const light::Directional&) {},
                          [&](const light::Spot& spot) {
                            if (!(spot.outer_angle < max_drawn_angle)) return;
                            radius = length * std::tan(glm::radians(spot.outer_angle));
                            add_circle(target, radius);
                          },
                          [&](const light::Rectangle& r) { add_rectangle(light.position, r); },
                          [&](const light::Disk& disk) { add_circle(light.position, disk.radius); },
                          [&](const light::Sphere& s) { add_circle(light.position, s.radius); }},
               light.kind);
  }

  static constexpr double max_drawn_angle = 80.0;  // degrees
  static constexpr std::size_t segments = 48;

 private:
  void add_circle(const glm::dvec3& center, double circle_radius) {
    const auto [u, v] = make_basis(axis);
    for (std::size_t i = 0; i < segments; ++i) {
      const double angle = glm::two_pi<double>() * static_cast<double>(i) / segments;
      outline.push_back(center + circle_radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  void add_rectangle(const glm::dvec3& center, const light::Rectangle& area) {
    const auto [right, up] = rectangle_axes(area);
    const glm::dvec3 x = 0.5 * area.width * right;
    const glm::dvec3 y = 0.5 * area.height * up;
    const std::array corners{center + x + y, center - x + y, center - x - y, center + x - y};
    constexpr std::size_t per_side = segments / 4;
    for (std::size_t i = 0; i < segments; ++i) {
      const std::size_t side = i / per_side;
      const double along = static_cast<double>(i % per_side) / per_side;
      outline.push_back(glm::mix(corners[side], corners[(side + 1) % 4], along));
    }
  }
};

namespace {

double film_distance(const CameraRays& rays, const glm::dvec3& point, QPointF position) {
  const glm::dvec3 projected = rays.project(point);
  return projected.z > 0.0 ? QLineF(QPointF(projected.x, projected.y), position).length()
                           : infinity;
}

}  // namespace

std::optional<LightHandles::Handle> LightHandles::pick(const CameraRays& rays,
                                                       QPointF position) const {
  const auto& lights = document_.scene().lights;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const glm::dvec3 projected = rays.project(handle_position(lights[k], document_.scene(), rays));
    if (projected.z <= 0.0 || lights[k].locked) continue;
    const double distance = QLineF(QPointF(projected.x, projected.y), position).length();
    if (distance <= sun_radius() + 3.0) return Handle{k, Part::light};
    if (!is_selected(k)) continue;
    const DrawnShape shape(lights[k], rays);
    if (has_target(lights[k]) && film_distance(rays, shape.target, position) <= sun_radius()) {
      return Handle{k, Part::target};
    }
    for (const glm::dvec3& point : shape.outline) {
      if (film_distance(rays, point, position) <= 1.5 * pick_distance())
        return Handle{k, Part::rim};
    }
    if (std::abs(distance - ring_radius(light_strength(lights[k]))) <= pick_distance()) {
      return Handle{k, Part::ring};
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
  document_.set_object(ObjectRef{ObjectRef::Kind::light, handle->light});
  gesture_ = {*handle, position, document_.scene().lights[handle->light], new_merge_id()};
  return true;
}

void LightHandles::move(const CameraRays& rays, QPointF position) {
  const auto [handle, start, before, merge_id] = *gesture_;
  if (handle.part == Part::target || handle.part == Part::rim) {
    const DrawnShape shape(before, rays);
    if (handle.part == Part::target) {
      const glm::dvec3 direction = glm::clamp(
          shape.target + dragged_across(shape.target, rays, start, position) - before.position,
          -limits::coordinate, limits::coordinate);
      if (!(glm::length(direction) > 0.0)) return;
      change_light(document_, handle.light, undo_text("Turn %1"), merge_id,
                   [&](Light& l) { turn(l, direction); });
    } else {
      const glm::dvec3 projected =
          rays.project(before.as<light::Spot>() ? shape.target : before.position);
      const double begin = QLineF(QPointF(projected.x, projected.y), start).length();
      const double now = QLineF(QPointF(projected.x, projected.y), position).length();
      open_or_scale(shape, now / std::max(begin, 1.0));
    }
  } else if (handle.part == Part::ring) {
    const glm::dvec3 projected = rays.project(handle_position(before, document_.scene(), rays));
    const double strength =
        strength_of(QLineF(QPointF(projected.x, projected.y), position).length());
    change_light(document_, handle.light, undo_text("Set intensity of %1"), merge_id,
                 [&](Light& l) { l.intensity = strength * light_color(before); });
  } else if (before.as<light::Directional>()) {
    const glm::dvec3 sun = handle_position(before, document_.scene(), rays);
    const glm::dvec3& target = document_.scene().camera.target;
    const glm::dvec3 direction = target - sun - dragged_across(sun, rays, start, position);
    if (!(glm::length(direction) > 1e-6 * glm::distance(sun, target))) return;
    change_light(document_, handle.light, undo_text("Turn %1"), merge_id,
                 [&](Light& l) { turn(l, glm::normalize(direction)); });
  } else {
    glm::dvec3 place = before.position + dragged_across(before.position, rays, start, position);
    place = glm::clamp(place, -limits::coordinate, limits::coordinate);
    change_light(document_, handle.light, undo_text("Move %1"), merge_id,
                 [&](Light& l) { l.position = place; });
  }
}

void LightHandles::open_or_scale(const DrawnShape& shape, double factor) {
  const Light& before = gesture_->before;
  const auto* spot = before.as<light::Spot>();
  if (spot == nullptr) {
    change_light(document_, gesture_->handle.light, undo_text("Set size of %1"), gesture_->merge_id,
                 [&](Light& l) {
                   l = before;
                   scale(l, factor);
                 });
    return;
  }
  const double angle = std::clamp(glm::degrees(std::atan(factor * shape.radius / shape.length)),
                                  0.1, DrawnShape::max_drawn_angle - 0.1);
  // The soft edge keeps its share.
  light::Spot opened = *spot;
  opened.inner_angle *= angle / spot->outer_angle;
  change_light(document_, gesture_->handle.light, undo_text("Set outer angle of %1"),
               gesture_->merge_id, [&](Light& l) { l.kind = with_outer_angle(opened, angle); });
}

void LightHandles::cancel() {
  const auto [handle, start, before, merge_id] = *gesture_;
  change_light(document_, handle.light, undo_text("Move %1"), merge_id,
               [&](Light& l) { l = before; });
  gesture_.reset();
}

void LightHandles::draw(Overlay& overlay, const CameraRays& rays) const {
  const auto& lights = document_.scene().lights;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const glm::dvec3 projected = rays.project(handle_position(lights[k], document_.scene(), rays));
    if (projected.z <= 0.0) continue;
    const QColor color = to_color(light_color(lights[k]));
    const int alpha = lights[k].on ? 230 : 90;
    const QRgb rgba = qRgba(color.red(), color.green(), color.blue(), alpha);
    const bool hovered = hovered_ && hovered_->light == k;
    draw_sun_icon(overlay, {projected.x, projected.y}, rgba, hovered);
    if (lights[k].as<light::Directional>()) {
      const glm::dvec3 sun = handle_position(lights[k], document_.scene(), rays);
      overlay.add_line(rays, sun, 0.5 * (sun + document_.scene().camera.target), rgba);
    }
    const bool active = is_selected(k);
    if (!active && !hovered && lights[k].as<light::Spot>()) continue;
    const DrawnShape shape(lights[k], rays);
    const auto line = [&](const glm::dvec3& start, const glm::dvec3& end, bool bright) {
      overlay.add_line(rays, start, end,
                       qRgba(color.red(), color.green(), color.blue(),
                             bright   ? 255
                             : active ? 150
                                      : 70));
    };
    if (has_target(lights[k]) && (active || hovered)) {
      line(lights[k].position, shape.target, hovered && hovered_->part == Part::target);
      const glm::dvec3 end = rays.project(shape.target);
      if (active && end.z > 0.0) overlay.add_circle(end.x, end.y, 0.6 * sun_radius(), rgba);
    }
    const bool bright_rim = hovered && hovered_->part == Part::rim;
    for (std::size_t i = 0; i < shape.outline.size(); ++i) {
      line(shape.outline[i], shape.outline[(i + 1) % shape.outline.size()], bright_rim);
      if (lights[k].as<light::Spot>() && i % (DrawnShape::segments / 4) == 0) {
        line(lights[k].position, shape.outline[i], bright_rim);
      }
    }
    if (active) {
      const bool bright = hovered && hovered_->part == Part::ring;
      overlay.add_circle(projected.x, projected.y, ring_radius(light_strength(lights[k])),
                         qRgba(color.red(), color.green(), color.blue(), bright ? 255 : 120));
    }
  }
}

}  // namespace brume
