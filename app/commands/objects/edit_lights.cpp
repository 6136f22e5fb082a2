#include "app/commands/objects/edit_lights.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>
#include <utility>

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "brume/limits.h"
#include "core/math/max_component.h"
#include "core/math/unit_direction.h"
#include "core/number_domain.h"
#include "core/overloaded.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/photometry.h"

namespace brume {

QString light_name(const Light& light, std::size_t index) {
  return light.name.empty() ? undo_text("light %1").arg(index + 1)
                            : QString::fromStdString(light.name);
}

QString light_unit(const Light& light) {
  return QString(strength_info(light).unit).replace("^2", "²");
}

namespace {

// The factor from a light's intensity to radiant intensity, `square` u^2 away [u^2].
double to_radiant_intensity(const Light& light, double square) {
  return std::visit(
      Overloaded{[](const light::Point&) { return 1.0; }, [](const light::Spot&) { return 1.0; },
                 [square](const light::Directional&) { return square; },
                 [](const AreaLight& area) { return facing_area(area); }},
      light.kind);
}

// Sets the size of a surface in all directions.
void set_size(Light& light, double size) {
  if (auto* rectangle = light.as<light::Rectangle>()) rectangle->width = rectangle->height = size;
  if (auto* radius = find_value<double>(light, "radius")) *radius = 0.5 * size;
}

// The side of the square that is as large, of a rectangle; else the diameter.
double size_of(const AreaLight& area) {
  const auto* rectangle = std::get_if<light::Rectangle>(&area);
  return rectangle ? std::sqrt(rectangle->width * rectangle->height) : 2.0 * bounding_radius(area);
}

// The size of a new surface is a tenth of the distance.
double new_size(double distance) {
  return std::clamp(0.1 * distance, 1e-6, 1e6);
}

// The values that both lights have, with their keyframes; of another strength none.
void copy_common_values(const Light& from, Light& to) {
  if (LightProfile* profile = profile_member(to); profile && profile_of(from)) {
    *profile = *profile_of(from);
  }
  if (auto* spot = to.as<light::Spot>(); spot && texture_of(from))
    spot->texture = *texture_of(from);
  visit_fields_of(to, [&]<class F>(const F& field) {
    const auto* value = find_value<typename F::Value>(from, field.info.name);
    if (value == nullptr) return;
    field.of(to) = *value;
    if constexpr (F::can_have_keys) to.keys.*field.keys = from.keys.*field.keys;
  });
}

}  // namespace

void set_kind(Light& light, const Light::Kind& kind, const LitRegion& region) {
  const auto* sun = light.as<light::Directional>();
  const glm::dvec3 place =
      sun ? region.center + 0.5 * region.diameter * to_light(*sun) : light.position;
  const glm::dvec3 inward = region.center - place;
  const double square = std::max(glm::dot(inward, inward), 1e-12);
  Light changed{.kind = kind, .name = light.name, .id = light.id};
  const auto area = area_of(light);
  set_size(changed, area ? size_of(*area) : new_size(glm::length(inward)));
  turn(changed, glm::length(inward) > 0.0 ? inward : glm::dvec3(0, -1, 0));
  copy_common_values(light, changed);
  changed.position = changed.as<light::Directional>() ? glm::dvec3(0.0) : place;
  changed.intensity = light.intensity *
                      (to_radiant_intensity(light, square) / to_radiant_intensity(changed, square));
  changed.intensity = glm::min(changed.intensity, limits::intensity);
  light = std::move(changed);
}

void scale(Light& light, double factor) {
  visit_fields_of(light, [&]<class F>(const F& field) {
    if constexpr (std::is_same_v<typename F::Value, double>) {
      if (std::string_view(field.info.unit) != "u") return;
      double& length = field.of(light);
      length = field.domain.nearest(factor * length);
    }
  });
}

std::optional<glm::dvec3> light_direction(const Light& light) {
  const auto* direction = find_value<glm::dvec3>(light, "direction");
  return direction ? std::optional(*direction) : std::nullopt;
}

void turn(Light& light, const glm::dvec3& direction) {
  if (auto* value = find_value<glm::dvec3>(light, "direction")) *value = direction;
}

namespace {

// Between the angles of a cone that the interface makes [degrees].
constexpr double min_angle_difference = 0.01;

void add(Document& document, Light light) {
  Lights lights = document.scene().lights;
  if (lights.size() >= limits::lights) return;
  lights.push_back(std::move(light));
  const QString name = light_name(lights.back(), lights.size() - 1);
  set_scene_part(document, std::move(lights), undo_text("Add %1").arg(name));
}

// It is as bright as those that are there, so that it is seen.
glm::dvec3 new_intensity(const Scene& scene) {
  const auto last =
      std::find_if(scene.lights.rbegin(), scene.lights.rend(), [](const Light& light) {
        return std::string_view(strength_info(light).name) == "intensity";
      });
  return glm::dvec3(last == scene.lights.rend() ? 20.0 : light_strength(*last));
}

// From above, behind the left shoulder.
glm::dvec3 sun_direction(const glm::dvec3& view) {
  const glm::dvec3 ahead = glm::length(view) > 0.0 ? glm::normalize(view) : glm::dvec3(0, 0, -1);
  const glm::dvec3 right = glm::cross(ahead, glm::dvec3(0, 1, 0));
  return ahead + 0.7 * right - glm::dvec3(0.0, 1.2, 0.0);
}

glm::dvec3 direction_to(const glm::dvec3& target, const glm::dvec3& position) {
  if (target == position) return light::Spot{}.direction;
  return glm::clamp(target - position, -limits::coordinate, limits::coordinate);
}

bool is_sun(const Light& light) {
  return light.as<light::Directional>() != nullptr;
}

void aim_sun(Light& sun, const LightPlace& place) {
  sun.position = {};
  turn(sun, sun_direction(place.target - place.eye));
}

}  // namespace

void add_light(Document& document, const Light::Kind& kind, const LightPlace& place) {
  Light light{.position = place.position, .kind = kind};
  const glm::dvec3 direction = direction_to(place.target, place.position);
  turn(light, direction);
  set_size(light, new_size(glm::length(direction)));
  if (light.as<light::Spot>()) light.kind = light::Spot{direction, 15.0, 20.0};
  if (is_sun(light)) {
    aim_sun(light, place);
    light.intensity = glm::dvec3(3.0);
  } else {
    light.intensity = glm::min(new_intensity(document.scene()) / to_radiant_intensity(light, 1.0),
                               glm::dvec3(limits::intensity));
  }
  add(document, std::move(light));
}

std::span<const LightPreset> light_presets() {
  static const std::array presets{
      LightPreset{"preset_sun", QT_TRANSLATE_NOOP("undo", "Sun"),
                  light::Directional{.angular_diameter = 0.53}, 5500.0, 3.0},
      LightPreset{"preset_moon", QT_TRANSLATE_NOOP("undo", "Moon"),
                  light::Directional{.angular_diameter = 0.52}, 7500.0, 0.15},
      LightPreset{"preset_headlight", QT_TRANSLATE_NOOP("undo", "Headlight"),
                  light::Spot{.inner_angle = 8.0, .outer_angle = 24.0}, 4300.0, 60.0},
      LightPreset{"preset_stage", QT_TRANSLATE_NOOP("undo", "Stage Spot"),
                  light::Spot{.inner_angle = 9.0, .outer_angle = 10.0}, 3200.0, 80.0},
      LightPreset{"preset_street", QT_TRANSLATE_NOOP("undo", "Street Lamp"),
                  light::Spot{.inner_angle = 40.0, .outer_angle = 75.0}, 2000.0, 20.0},
      LightPreset{"preset_window", QT_TRANSLATE_NOOP("undo", "Window"),
                  light::Rectangle{.width = 1.0, .height = 1.4}, 6500.0, 15.0},
      LightPreset{"preset_candle", QT_TRANSLATE_NOOP("undo", "Candle"), light::Point{}, 1850.0,
                  2.0}};
  return presets;
}

void add_preset(Document& document, const LightPreset& preset, const LightPlace& place) {
  Light light{.position = place.position,
              .intensity = preset.strength * black_body_color(preset.temperature),
              .kind = preset.kind};
  turn(light, direction_to(place.target, place.position));
  if (is_sun(light)) aim_sun(light, place);
  add(document, std::move(light));
}

Light light_outside(const glm::dvec3& center, double radius, const glm::dvec3& eye) {
  const double distance = 4.0 * radius;
  const glm::dvec3 position = center - distance * glm::normalize(sun_direction(center - eye));
  Light light;
  light.position = glm::clamp(position, -limits::coordinate, limits::coordinate);
  light.intensity = glm::dvec3(std::min(std::numbers::pi * distance * distance, limits::intensity));
  return light;
}

Camera camera_at(const Light& light, const LitRegion& region, const glm::dvec3& target) {
  constexpr double widest = 150.0;  // degrees
  Camera camera;
  camera.vertical_fov = 90.0;
  camera.eye = light.position;
  if (const auto* sun = light.as<light::Directional>()) {
    camera.eye = region.center + region.diameter * to_light(*sun);
    camera.vertical_fov = 60.0;
  }
  if (const auto* spot = light.as<light::Spot>()) {
    camera.vertical_fov = std::min(2.0 * spot->outer_angle, widest);
  }
  const glm::dvec3 towards = light_direction(light).value_or(target - camera.eye);
  const glm::dvec3 axis = unit_direction(towards, {0.0, 0.0, -1.0});
  // The distance is that of the target, so that orbits go around what is lit there.
  const double distance = std::max(glm::dot(target - camera.eye, axis), 0.1 * region.diameter);
  camera.target = camera.eye + distance * axis;
  if (const auto* rectangle = light.as<light::Rectangle>()) {
    camera.up = rectangle_axes(*rectangle).second;
  } else if (std::abs(axis.y) > 0.999) {
    camera.up = {0.0, 0.0, -1.0};
  }
  return camera;
}

light::Spot with_inner_angle(light::Spot spot, double angle) {
  spot.inner_angle = std::clamp(angle, 0.0, domain::cone_angle.max_value - min_angle_difference);
  spot.outer_angle = std::max(spot.outer_angle, spot.inner_angle + min_angle_difference);
  return spot;
}

light::Spot with_outer_angle(light::Spot spot, double angle) {
  spot.outer_angle = std::clamp(angle, min_angle_difference, domain::cone_angle.max_value);
  spot.inner_angle = std::clamp(spot.inner_angle, 0.0, spot.outer_angle - min_angle_difference);
  return spot;
}

void set_profile(Light& light, LightProfile profile) {
  if (auto* member = profile_member(light)) *member = std::move(profile);
  if (!profile_of(light)) light.keys.profile_rotation.clear();
}

void set_texture(Light& light, LightTexture texture) {
  auto* spot = light.as<light::Spot>();
  if (!spot) return;
  spot->texture = std::move(texture);
  if (texture_of(light)) return;
  light.keys.texture_rotation.clear();
  light.keys.texture_focus.clear();
}

double light_strength(const Light& light) {
  return max_component(light.intensity);
}

glm::dvec3 light_color(const Light& light) {
  const double strength = light_strength(light);
  return strength > 0.0 ? light.intensity / strength : glm::dvec3(1.0);
}

}  // namespace brume
