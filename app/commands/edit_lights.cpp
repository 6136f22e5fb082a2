#include "app/commands/edit_lights.h"

#include <algorithm>

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "core/limits.h"

namespace brume {

QString light_name(std::size_t index) {
  return undo_text("light %1").arg(index + 1);
}

void add_light(Document& document, const glm::dvec3& position) {
  Lights lights = document.scene().lights;
  if (lights.size() >= limits::lights) return;
  PointLight light;
  light.position = position;
  // As bright as those that are there, so that it is seen.
  light.intensity = glm::dvec3(lights.empty() ? 20.0 : light_strength(lights.back()));
  lights.push_back(light);
  const std::size_t index = lights.size() - 1;
  set_scene_part(document, std::move(lights), undo_text("Add %1").arg(light_name(index)));
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
