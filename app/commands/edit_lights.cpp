#include "app/commands/edit_lights.h"

#include <algorithm>
#include <glm/common.hpp>

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "core/limits.h"
#include "core/number_domain.h"

namespace brume {

QString light_name(std::size_t index) {
  return undo_text("light %1").arg(index + 1);
}

namespace {

// Between the angles of a cone that the interface makes [degrees].
constexpr double min_angle_difference = 0.01;

void add(Document& document, PointLight light) {
  Lights lights = document.scene().lights;
  if (lights.size() >= limits::lights) return;
  // As bright as those that are there, so that it is seen.
  light.intensity = glm::dvec3(lights.empty() ? 20.0 : light_strength(lights.back()));
  lights.push_back(light);
  const std::size_t index = lights.size() - 1;
  set_scene_part(document, std::move(lights), undo_text("Add %1").arg(light_name(index)));
}

}  // namespace

void add_light(Document& document, const glm::dvec3& position) {
  PointLight light;
  light.position = position;
  add(document, std::move(light));
}

void add_spot(Document& document, const glm::dvec3& position, const glm::dvec3& target) {
  PointLight light;
  light.position = position;
  light.spot = SpotCone{.inner_angle = 15.0, .outer_angle = 20.0};
  if (target != position) {
    light.spot->direction = glm::clamp(target - position, -limits::coordinate, limits::coordinate);
  }
  add(document, std::move(light));
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
                  const std::function<void(PointLight&)>& change) {
  Lights lights = document.scene().lights;
  if (index >= lights.size()) return;
  change(lights[index]);
  set_scene_part(document, std::move(lights), verb.arg(light_name(index)), merge_id);
}

double light_strength(const PointLight& light) {
  return std::max({light.intensity.r, light.intensity.g, light.intensity.b});
}

glm::dvec3 light_color(const PointLight& light) {
  const double strength = light_strength(light);
  return strength > 0.0 ? light.intensity / strength : glm::dvec3(1.0);
}

}  // namespace brume
