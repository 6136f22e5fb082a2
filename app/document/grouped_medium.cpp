#include "app/document/grouped_medium.h"

#include <utility>

namespace brume {

void GroupedMedium::update(const Scene& scene) {
  GroupEffects effects(scene.groups);
  const bool is_same = scene.medium.revision() == revision_ && scene.optics.albedo == albedo_ &&
                       effects.change_as(effects_);
  effects_ = std::move(effects);
  hidden_ = hidden_by_groups(scene.medium, effects_);
  locked_ = locked_by_groups(scene.medium, effects_);
  if (is_same) return;
  revision_ = scene.medium.revision();
  albedo_ = scene.optics.albedo;
  medium_ = effects_.any_change() ? with_effects(scene.medium, effects_, albedo_) : Medium();
}

}  // namespace brume
