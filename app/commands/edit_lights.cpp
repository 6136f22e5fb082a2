#include "app/commands/edit_lights.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "brume/limits.h"
#include "core/math/unit_direction.h"
#include "core/number_domain.h"
#include "core/scene/lights/photometry.h"

namespace brume {

QString light_name(const Light& light, std::size_t index) {
  return light.name.empty() ? undo_text("light %1").arg(index + 1)
                            : QString::fromStdString(light.name);
}

QString light_title(const Light& light, std::size_t index) {
  if (!light.name.empty()) return QString::fromStdString(light.name);
  static constexpr std::array titles{
      QT_TRANSLATE_NOOP("undo", "Light %1"),      QT_TRANSLATE_NOOP("undo", "Spot %1"),
      QT_TRANSLATE_NOOP("undo", "Sun %1"),        QT_TRANSLATE_NOOP("undo", "Rectangle %1"),
      QT_TRANSLATE_NOOP("undo", "Disk light %1"), QT_TRANSLATE_NOOP("undo", "Sphere %1")};
  return undo_text(titles[static_cast<std::size_t>(type_of(light))]).arg(index + 1);
}

QString light_unit(const Light& light) {
  return light.directional ? QStringLiteral("W/u²")
         : light.area      ? QStringLiteral("W/(sr u²)")
                           : QStringLiteral("W/sr");
}

namespace {

constexpr auto first_area = static_cast<int>(LightType::rectangle);

std::optional<AreaLight::Shape> shape_of(LightType type) {
  const int shape = static_cast<int>(type) - first_area;
  return shape >= 0 ? std::optional(static_cast<AreaLight::Shape>(shape)) : std::nullopt;
}

// The factor from a light's intensity to radiant intensity, `square` u^2 away [u^2].
double to_radiant_intensity(const Light& light, double square) {
  return light.directional ? square : light.area ? facing_area(*light.area) : 1.0;
}

// Its size is a tenth of the distance.
AreaLight new_area(AreaLight::Shape shape, const glm::dvec3& direction) {
  AreaLight area{shape, direction};
  area.width = area.height = std::clamp(0.1 * glm::length(direction), 1e-6, 1e6);
  area.radius = 0.5 * area.width;
  return area;
}

}  // namespace

LightType type_of(const Light& light) {
  if (light.area) return static_cast<LightType>(first_area + static_cast<int>(light.area->shape));
  return light.directional ? LightType::directional
         : light.spot      ? LightType::spot
                           : LightType::point;
}

void set_type(Light& light, LightType type, const LitRegion& region) {
  const glm::dvec3 place =
      light.directional ? region.center + 0.5 * region.diameter * to_light(*light.directional)
                        : light.position;
  const glm::dvec3 inward = region.center - place;
  const double square = std::max(glm::dot(inward, inward), 1e-12);
  const glm::dvec3 direction =
      light_direction(light).value_or(glm::length(inward) > 0.0 ? inward : glm::dvec3(0, -1, 0));
  const LightType before = type_of(light);
  const double radiant = to_radiant_intensity(light, square);
  const std::optional<AreaLight> old_area = light.area;
  light.spot.reset();
  light.directional.reset();
  light.area.reset();
  if (type != LightType::point && type != LightType::spot) light.profile = {};
  light.position = place;
  if (type == LightType::directional) {
    light.position = {};
    light.directional = Directional{direction};
  } else if (type == LightType::spot) {
    light.spot = SpotCone{direction};
  } else if (const auto shape = shape_of(type)) {
    light.area = old_area ? *old_area : new_area(*shape, inward);
    light.area->shape = *shape;
    light.area->direction = direction;
  }
  // Keyframes stay of what the types have in common.
  const LightKeys keys = std::exchange(light.keys, {});
  const auto is_alike = [](LightType a, LightType b) {
    const auto kind = [](LightType t) { return std::min(static_cast<int>(t), first_area); };
    return kind(a) == kind(b) || std::max(kind(a), kind(b)) == static_cast<int>(LightType::spot);
  };
  if (type != LightType::directional && before != LightType::directional) {
    light.keys.position = keys.position;
  }
  if (is_alike(before, type)) light.keys.intensity = keys.intensity;
  if (light_direction(light)) light.keys.direction = keys.direction;
  if (light.profile.content) light.keys.profile_rotation = keys.profile_rotation;
  if (type == before) light.keys = keys;
  light.intensity *= radiant / to_radiant_intensity(light, square);
  light.intensity = glm::min(light.intensity, limits::intensity);
}

std::optional<glm::dvec3> light_direction(const Light& light) {
  if (light.directional) return light.directional->direction;
  if (light.area && light.area->shape != AreaLight::Shape::sphere) return light.area->direction;
  return light.spot ? std::optional(light.spot->direction) : std::nullopt;
}

void turn(Light& light, const glm::dvec3& direction) {
  if (light.directional) light.directional->direction = direction;
  if (light.spot) light.spot->direction = direction;
  if (light.area) light.area->direction = direction;
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
      std::find_if(scene.lights.rbegin(), scene.lights.rend(),
                   [](const Light& light) { return !light.directional && !light.area; });
  return glm::dvec3(last == scene.lights.rend() ? 20.0 : light_strength(*last));
}

// From above, behind the left shoulder.
glm::dvec3 sun_direction(const glm::dvec3& view) {
  const glm::dvec3 ahead = glm::length(view) > 0.0 ? glm::normalize(view) : glm::dvec3(0, 0, -1);
  const glm::dvec3 right = glm::cross(ahead, glm::dvec3(0, 1, 0));
  return ahead + 0.7 * right - glm::dvec3(0.0, 1.2, 0.0);
}

glm::dvec3 direction_to(const glm::dvec3& target, const glm::dvec3& position) {
  if (target == position) return SpotCone{}.direction;
  return glm::clamp(target - position, -limits::coordinate, limits::coordinate);
}

}  // namespace

void add_light(Document& document, LightType type, const LightPlace& place) {
  Light light;
  light.position = place.position;
  light.intensity = new_intensity(document.scene());
  const glm::dvec3 direction = direction_to(place.target, place.position);
  if (type == LightType::spot) {
    light.spot = SpotCone{direction, 15.0, 20.0};
  } else if (type == LightType::directional) {
    light.position = {};
    light.intensity = glm::dvec3(3.0);
    light.directional = Directional{sun_direction(place.target - place.eye)};
  } else if (const auto shape = shape_of(type)) {
    light.area = new_area(*shape, direction);
    light.intensity =
        glm::min(light.intensity / facing_area(*light.area), glm::dvec3(limits::intensity));
  }
  add(document, std::move(light));
}

namespace {

constexpr std::array<LightPreset, 7> presets{{
    {"preset_sun", QT_TRANSLATE_NOOP("undo", "Sun"), LightType::directional, 5500.0, 3.0, 0, 0,
     0.53},
    {"preset_moon", QT_TRANSLATE_NOOP("undo", "Moon"), LightType::directional, 7500.0, 0.15, 0, 0,
     0.52},
    {"preset_headlight", QT_TRANSLATE_NOOP("undo", "Headlight"), LightType::spot, 4300.0, 60.0, 8.0,
     24.0},
    {"preset_stage", QT_TRANSLATE_NOOP("undo", "Stage spot"), LightType::spot, 3200.0, 80.0, 9.0,
     10.0},
    {"preset_street", QT_TRANSLATE_NOOP("undo", "Street lamp"), LightType::spot, 2000.0, 20.0, 40.0,
     75.0},
    {"preset_window", QT_TRANSLATE_NOOP("undo", "Window"), LightType::rectangle, 6500.0, 15.0, 0, 0,
     0, 1.0, 1.4},
    {"preset_candle", QT_TRANSLATE_NOOP("undo", "Candle"), LightType::point, 1850.0, 2.0},
}};

}  // namespace

std::span<const LightPreset> light_presets() {
  return presets;
}

void add_preset(Document& document, const LightPreset& preset, const LightPlace& place) {
  Light light;
  light.intensity = preset.strength * black_body_color(preset.temperature);
  light.position = place.position;
  const glm::dvec3 direction = direction_to(place.target, place.position);
  if (preset.type == LightType::directional) {
    light.position = {};
    light.directional =
        Directional{sun_direction(place.target - place.eye), preset.angular_diameter};
  } else if (preset.type == LightType::spot) {
    light.spot = SpotCone{direction, preset.inner_angle, preset.outer_angle};
  } else if (preset.type == LightType::rectangle) {
    light.area = AreaLight{.direction = direction, .width = preset.width, .height = preset.height};
  }
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
  if (light.directional) {
    camera.eye = region.center + region.diameter * to_light(*light.directional);
    camera.vertical_fov = 60.0;
  }
  if (light.spot) camera.vertical_fov = std::min(2.0 * light.spot->outer_angle, widest);
  const glm::dvec3 towards = light_direction(light).value_or(target - camera.eye);
  const glm::dvec3 axis = unit_direction(towards, {0.0, 0.0, -1.0});
  // The distance is that of the target, so that orbits go around what is lit there.
  const double distance = std::max(glm::dot(target - camera.eye, axis), 0.1 * region.diameter);
  camera.target = camera.eye + distance * axis;
  if (light.area && light.area->shape == AreaLight::Shape::rectangle) {
    camera.up = rectangle_axes(*light.area).second;
  } else if (std::abs(axis.y) > 0.999) {
    camera.up = {0.0, 0.0, -1.0};
  }
  return camera;
}

SpotCone with_inner_angle(SpotCone cone, double angle) {
  cone.inner_angle = std::clamp(angle, 0.0, domain::cone_angle.max_value - min_angle_difference);
  cone.outer_angle = std::max(cone.outer_angle, cone.inner_angle + min_angle_difference);
  return cone;
}

void set_profile(Light& light, LightProfile profile) {
  light.profile = std::move(profile);
  if (!light.profile.content) light.keys.profile_rotation.clear();
}

SpotCone with_outer_angle(SpotCone cone, double angle) {
  cone.outer_angle = std::clamp(angle, min_angle_difference, domain::cone_angle.max_value);
  cone.inner_angle = std::clamp(cone.inner_angle, 0.0, cone.outer_angle - min_angle_difference);
  return cone;
}

void delete_light(Document& document, std::size_t index) {
  Lights lights = document.scene().lights;
  if (index >= lights.size()) return;
  const QString name = light_name(lights[index], index);
  lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(index));
  set_scene_part(document, std::move(lights), undo_text("Delete %1").arg(name));
}

void change_light(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                  const std::function<void(Light&)>& change) {
  Lights lights = document.scene().lights;
  if (index >= lights.size()) return;
  const QString name = light_name(lights[index], index);
  change(lights[index]);
  set_scene_part(document, std::move(lights), verb.arg(name), merge_id);
}

double light_strength(const Light& light) {
  return std::max({light.intensity.r, light.intensity.g, light.intensity.b});
}

glm::dvec3 light_color(const Light& light) {
  const double strength = light_strength(light);
  return strength > 0.0 ? light.intensity / strength : glm::dvec3(1.0);
}

}  // namespace brume
