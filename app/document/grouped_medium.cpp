#include "app/document/grouped_medium.h"

#include <algorithm>
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

std::vector<GaussianId> members_of(const Scene& scene, GroupId group) {
  const Groups& groups = scene.groups;
  const Medium& medium = scene.medium;
  GroupId last = group;
  for (const Group& other : groups) last = std::max(last, other.id);
  std::vector<bool> is_chosen(last + std::size_t{1});
  is_chosen[group] = true;
  for (const Group& other : groups) {
    if (group != 0 && other.parent == group) is_chosen[other.id] = true;
  }
  std::vector<GaussianId> ids;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const GroupId own_group = medium.group(i);
    if (own_group <= last && is_chosen[own_group]) ids.push_back(medium.ids()[i]);
  }
  return ids;
}

}  // namespace brume
