#include "core/scene/group_effects.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/number_domain.h"

namespace brume {
namespace {

double within(const NumberDomain& domain, double value) {
  return std::clamp(value, domain.min_value, domain.max_value);
}

GroupEffect effect_of(const Group& group) {
  return {.visible = group.visible,
          .locked = group.locked,
          .density_factor = group.density_factor,
          .density_offset = group.density_offset,
          .radius_factor = group.radius_factor,
          .radius_offset = group.radius_offset,
          .albedo_factor = group.albedo_factor,
          .albedo_offset = group.albedo_offset};
}

// First `inner`, then `outer`.
GroupEffect combined(const GroupEffect& inner, const GroupEffect& outer) {
  return {
      .visible = inner.visible && outer.visible,
      .locked = inner.locked || outer.locked,
      .density_factor = outer.density_factor * inner.density_factor,
      .density_offset = outer.density_factor * inner.density_offset + outer.density_offset,
      .radius_factor = outer.radius_factor * inner.radius_factor,
      .radius_offset = outer.radius_factor * inner.radius_offset + outer.radius_offset,
      .albedo_factor = outer.albedo_factor * inner.albedo_factor,
      .albedo_offset = outer.albedo_factor * inner.albedo_offset + outer.albedo_offset,
  };
}

std::vector<GaussianId> members_of(const Medium& medium, const GroupEffects& effects,
                                   bool (*is_chosen)(const GroupEffect&)) {
  std::vector<GaussianId> ids;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (is_chosen(effects.of(medium.group(i)))) ids.push_back(medium.ids()[i]);
  }
  return ids;
}

}  // namespace

bool GroupEffect::changes_gaussians() const {
  return !changes_as({});
}

bool GroupEffect::changes_as(const GroupEffect& other) const {
  return density_factor == other.density_factor && density_offset == other.density_offset &&
         radius_factor == other.radius_factor && radius_offset == other.radius_offset &&
         albedo_factor == other.albedo_factor && albedo_offset == other.albedo_offset;
}

Gaussian GroupEffect::applied(Gaussian gaussian, const glm::dvec3& medium_albedo) const {
  gaussian.density = within(domain::density, density_factor * gaussian.density + density_offset);
  gaussian.radius = within(domain::length, radius_factor * gaussian.radius + radius_offset);
  if (albedo_factor != glm::dvec3(1.0) || albedo_offset != glm::dvec3(0.0)) {
    const glm::dvec3 albedo = gaussian.optics.albedo.value_or(medium_albedo);
    gaussian.optics.albedo = glm::clamp(albedo_factor * albedo + albedo_offset,
                                        domain::albedo.min_value, domain::albedo.max_value);
  }
  return gaussian;
}

GroupEffects::GroupEffects(std::span<const Group> groups) {
  for (const Group& group : groups) ids_.push_back(group.id);
  std::sort(ids_.begin(), ids_.end());
  for (const GroupId id : ids_) {
    const Group& group = *find_group(groups, id);
    GroupEffect effect = effect_of(group);
    if (const Group* parent = find_group(groups, group.parent)) {
      effect = combined(effect, effect_of(*parent));
    }
    any_hidden_ = any_hidden_ || !effect.visible;
    any_locked_ = any_locked_ || effect.locked;
    any_change_ = any_change_ || effect.changes_gaussians();
    effects_.push_back(effect);
  }
}

bool GroupEffects::change_as(const GroupEffects& others) const {
  return ids_ == others.ids_ &&
         std::ranges::equal(effects_, others.effects_,
                            [](const auto& a, const auto& b) { return a.changes_as(b); });
}

const GroupEffect& GroupEffects::of(GroupId id) const {
  static const GroupEffect none;
  const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (found == ids_.end() || *found != id) return none;
  return effects_[static_cast<std::size_t>(found - ids_.begin())];
}

const Group* find_group(std::span<const Group> groups, GroupId id) {
  const auto found = std::ranges::find(groups, id, &Group::id);
  return found == groups.end() ? nullptr : &*found;
}

Medium with_effects(const Medium& medium, const GroupEffects& effects,
                    const glm::dvec3& medium_albedo) {
  if (!effects.any_change()) return medium;
  return medium.changed(medium.homogeneous_density(), [&](const Gaussian& gaussian) {
    const GroupEffect& effect = effects.of(gaussian.group);
    return effect.changes_gaussians() ? effect.applied(gaussian, medium_albedo) : gaussian;
  });
}

std::vector<GaussianId> hidden_by_groups(const Medium& medium, const GroupEffects& effects) {
  if (!effects.any_hidden()) return {};
  return members_of(medium, effects, [](const GroupEffect& effect) { return !effect.visible; });
}

std::vector<GaussianId> locked_by_groups(const Medium& medium, const GroupEffects& effects) {
  if (!effects.any_locked()) return {};
  return members_of(medium, effects, [](const GroupEffect& effect) { return effect.locked; });
}

}  // namespace brume
