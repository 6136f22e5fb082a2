#include "app/commands/edit_lights.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "core/limits.h"
#include "core/number_domain.h"
#include "core/scene/photometry.h"

namespace brume {

QString light_name(std::size_t index) {
  return undo_text("light %1").arg(index + 1);
}

QString light_title(const Light& light, std::size_t index) {
  const QString title = light.directional ? undo_text("Sun %1")
                        : light.spot      ? undo_text("Spot %1")
                                          : undo_text("Light %1");
  return title.arg(index + 1);
}

QString light_unit(const Light& light) {
  return light.directional ? QStringLiteral("W/u²") : QStringLiteral("W/sr");
}

LightType type_of(const Light& light) {
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
  const bool was_directional = light.directional.has_value();
  light.spot.reset();
  light.directional.reset();
  light.position = place;
  // Keyframes stay of what the types have in common.
  if (was_directional != (type == LightType::directional)) {
    light.keys.position = light.keys.intensity = {};
  }
  if (type == LightType::point) light.keys.direction = {};
  if (type != LightType::spot) light.keys.inner_angle = light.keys.outer_angle = {};
  if (type != LightType::directional) light.keys.angular_diameter = {};
  if (type == LightType::directional) {
    light.position = {};
    light.directional = Directional{direction};
  } else if (type == LightType::spot) {
    light.spot = SpotCone{direction};
  }
  if (was_directional) light.intensity *= square;
  if (type == LightType::directional) light.intensity /= square;
  light.intensity = glm::min(light.intensity, limits::intensity);
}

std::optional<glm::dvec3> light_direction(const Light& light) {
  if (light.directional) return light.directional->direction;
  return light.spot ? std::optional(light.spot->direction) : std::nullopt;
}

void turn(Light& light, const glm::dvec3& direction) {
  if (light.directional) light.directional->direction = direction;
  if (light.spot) light.spot->direction = direction;
}

namespace {

// Between the angles of a cone that the interface makes [degrees].
constexpr double min_angle_difference = 0.01;

void add(Document& document, Light light) {
  Lights lights = document.scene().lights;
  if (lights.size() >= limits::lights) return;
  lights.push_back(std::move(light));
  const std::size_t index = lights.size() - 1;
  set_scene_part(document, std::move(lights), undo_text("Add %1").arg(light_name(index)));
}

// As bright as those that are there, so that it is seen.
glm::dvec3 new_intensity(const Scene& scene) {
  const auto last = std::find_if(scene.lights.rbegin(), scene.lights.rend(),
                                 [](const Light& light) { return !light.directional; });
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

void add_light(Document& document, const glm::dvec3& position) {
  Light light;
  light.position = position;
  light.intensity = new_intensity(document.scene());
  add(document, std::move(light));
}

void add_spot(Document& document, const glm::dvec3& position, const glm::dvec3& target) {
  Light light;
  light.position = position;
  light.intensity = new_intensity(document.scene());
  light.spot = SpotCone{direction_to(target, position), 15.0, 20.0};
  add(document, std::move(light));
}

void add_directional(Document& document, const glm::dvec3& view) {
  Light light;
  light.intensity = glm::dvec3(3.0);
  light.directional = Directional{sun_direction(view)};
  add(document, std::move(light));
}

namespace {

constexpr std::array<LightPreset, 6> presets{{
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
    {"preset_candle", QT_TRANSLATE_NOOP("undo", "Candle"), LightType::point, 1850.0, 2.0},
}};

}  // namespace

std::span<const LightPreset> light_presets() {
  return presets;
}

void add_preset(Document& document, const LightPreset& preset, const glm::dvec3& position,
                const glm::dvec3& target, const glm::dvec3& eye) {
  Light light;
  light.intensity = preset.strength * black_body_color(preset.temperature);
  if (preset.type == LightType::directional) {
    light.directional = Directional{sun_direction(target - eye), preset.angular_diameter};
  } else {
    light.position = position;
  }
  if (preset.type == LightType::spot) {
    light.spot = SpotCone{direction_to(target, position), preset.inner_angle, preset.outer_angle};
  }
  add(document, std::move(light));
}

glm::dvec3 handle_position(const Light& light, const Scene& scene, const glm::dvec3& eye) {
  if (!light.directional) return light.position;
  const glm::dvec3& target = scene.camera.target;
  return target + 0.2 * glm::distance(eye, target) * to_light(*light.directional);
}

SpotCone with_inner_angle(SpotCone cone, double angle) {
  cone.inner_angle = std::clamp(angle, 0.0, domain::cone_angle.max_value - min_angle_difference);
  cone.outer_angle = std::max(cone.outer_angle, cone.inner_angle + min_angle_difference);
  return cone;
}

SpotCone with_outer_angle(SpotCone cone, double angle) {
  cone.outer_angle = std::clamp(angle, min_angle_difference, domain::cone_angle.max_value);
  cone.inner_angle = std::clamp(cone.inner_angle, 0.0, cone.outer_angle - min_angle_difference);
  return cone;
}

void delete_light(Document& document, std::size_t index) {
  Lights lights = document.scene().lights;
  if (index >= lights.size()) return;
  lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(index));
  set_scene_part(document, std::move(lights), undo_text("Delete %1").arg(light_name(index)));
}

void change_light(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                  const std::function<void(Light&)>& change) {
  Lights lights = document.scene().lights;
  if (index >= lights.size()) return;
  change(lights[index]);
  set_scene_part(document, std::move(lights), verb.arg(light_name(index)), merge_id);
}

double light_strength(const Light& light) {
  return std::max({light.intensity.r, light.intensity.g, light.intensity.b});
}

glm::dvec3 light_color(const Light& light) {
  const double strength = light_strength(light);
  return strength > 0.0 ? light.intensity / strength : glm::dvec3(1.0);
}

}  // namespace brume
