#include "app/commands/objects/edit_environment.h"

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "core/scene/lights/sky.h"

namespace brume {

QString environment_text(const Environment& environment) {
  return environment.sky ? undo_text("Sky") : to_qstring(environment.file.filename());
}

void add_sky(Document& document) {
  constexpr double intensity = 0.03;
  Environment environment = document.scene().environment.value_or(
      Environment{.file = {}, .map = nullptr, .intensity = intensity});
  environment.file.clear();
  environment.map.reset();
  environment.sky.emplace();
  set_scene_part(document, std::optional(std::move(environment)), undo_text("Set sky"), no_merge);
}

void move_sun(Document& document, const glm::dvec3& direction, MergeId gesture) {
  Environment environment = document.scene().environment.value();
  aim_sun(environment, direction, environment.sky.value());
  set_scene_part(document, std::optional(std::move(environment)), undo_text("Move sun"), gesture);
}

void put_back_environment(Document& document, const Environment& environment, MergeId gesture) {
  set_scene_part(document, std::optional(environment), undo_text("Move sun"), gesture);
}

}  // namespace brume
