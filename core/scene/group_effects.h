#pragma once

#include <span>
#include <vector>

#include "brume/group.h"
#include "brume/medium.h"

namespace brume {

// The effect of a group and its parent together on a Gaussian.
struct GroupEffect {
  bool visible = true;
  bool locked = false;
  double density_factor = 1.0;
  double density_offset = 0.0;  // [1/u]
  double radius_factor = 1.0;
  double radius_offset = 0.0;  // [u]
  glm::dvec3 albedo_factor{1.0};
  glm::dvec3 albedo_offset{0.0};

  // Whether it changes Gaussians at all; being hidden or locked is no change.
  [[nodiscard]] bool changes_gaussians() const;
  [[nodiscard]] bool changes_as(const GroupEffect& other) const;
  // Within the domains of files. One without an albedo of its own starts from the medium's.
  [[nodiscard]] Gaussian applied(Gaussian gaussian, const glm::dvec3& medium_albedo) const;
};

// The effects of all groups of a scene, by their ids.
class GroupEffects {
 public:
  GroupEffects() = default;
  explicit GroupEffects(std::span<const Group> groups);

  // The effect of a group; none for id 0, or an id that no group has.
  [[nodiscard]] const GroupEffect& of(GroupId id) const;
  [[nodiscard]] bool any_hidden() const { return any_hidden_; }
  [[nodiscard]] bool any_locked() const { return any_locked_; }
  // Whether any group changes Gaussians; and whether all do as those of others.
  [[nodiscard]] bool any_change() const { return any_change_; }
  [[nodiscard]] bool change_as(const GroupEffects& others) const;

 private:
  std::vector<GroupId> ids_;  // ascending
  std::vector<GroupEffect> effects_;
  bool any_hidden_ = false;
  bool any_locked_ = false;
  bool any_change_ = false;
};

// The group of an id; nullptr: there is none.
const Group* find_group(std::span<const Group> groups, GroupId id);

// A medium with what its groups make of its Gaussians; hidden ones are still there. Of the same
// revision if nothing changes.
Medium with_effects(const Medium& medium, const GroupEffects& effects,
                    const glm::dvec3& medium_albedo);

// Ids of the Gaussians whose group is hidden, or locked; ascending.
std::vector<GaussianId> hidden_by_groups(const Medium& medium, const GroupEffects& effects);
std::vector<GaussianId> locked_by_groups(const Medium& medium, const GroupEffects& effects);

}  // namespace brume
