#pragma once

#include <vector>

#include "brume/scene.h"
#include "core/scene/group_effects.h"

namespace brume {

// The medium as the groups of a scene make it; of the same revision while neither of them, nor
// the albedo they start from, has changed.
class GroupedMedium {
 public:
  // Costs little where nothing has changed.
  void update(const Scene& scene);

  [[nodiscard]] const GroupEffects& effects() const { return effects_; }
  // The medium of the scene it was updated with, whose own one is `plain`.
  [[nodiscard]] const Medium& medium(const Medium& plain) const {
    return effects_.any_change() ? medium_ : plain;
  }
  // Those whose group is hidden, or locked; ordered by id.
  [[nodiscard]] const std::vector<GaussianId>& hidden() const { return hidden_; }
  [[nodiscard]] const std::vector<GaussianId>& locked() const { return locked_; }

 private:
  GroupEffects effects_;
  glm::dvec3 albedo_{1.0};
  Revision revision_ = 0;  // of the plain medium
  Medium medium_;          // unused without any change
  std::vector<GaussianId> hidden_;
  std::vector<GaussianId> locked_;
};

// The Gaussians of a group and of the groups in it; of 0 those in no group. Ordered by id.
std::vector<GaussianId> members_of(const Scene& scene, GroupId group);

}  // namespace brume
