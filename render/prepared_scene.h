#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "render/cpu/light_table.h"
#include "render/cpu/path_depths.h"
#include "render/cpu/shadow_map.h"
#include "render/cpu/visibility.h"
#include "render/medium_index.h"
#include "render/reference/occluders.h"
#include "render/settings.h"

namespace brume {

// What rendering needs of a scene and keeps from frame to frame. What has changed is found by
// comparing values, and only what depends on it is made again: a moved camera renews nothing
// here, a moved light only what is its own, and an edited Gaussian the part of each light's table
// that it is seen in.
class PreparedScene {
 public:
  // Makes the medium's and the surfaces' parts fit the scene, and forgets what belongs to lights
  // that are not among `lights`. If memory runs out, nothing old is taken for new.
  void update(const Scene& scene, std::span<const PointLight> lights, const Settings& settings);

  // From here on, of the last update().
  [[nodiscard]] const MediumIndex& medium() const { return *index_; }
  // Another number whenever medium() is another, its noise aside.
  [[nodiscard]] std::uint64_t medium_revision() const { return medium_revision_; }
  [[nodiscard]] const Visibility& visibility() const { return *visibility_; }
  // Another number whenever visibility() is another.
  [[nodiscard]] std::uint64_t visibility_revision() const { return visibility_revision_; }
  [[nodiscard]] const Occluders& occluders() const { return *occluders_; }  // of the reference only

  // Made when first asked for. The pairs that this evaluates are added to `pairs`. References
  // hold until the next update().
  const CenterDepths& light_depths(const glm::dvec3& light, Settings::Arithmetic arithmetic,
                                   std::uint64_t& pairs);
  const LightTable& light_table(const glm::dvec3& light, const LightTableSize& size,
                                std::uint64_t& pairs);
  const ShadowMap& shadow_map(const glm::dvec3& light, const DirectionMap& map);

 private:
  std::unique_ptr<MediumIndex> index_;
  std::uint64_t medium_revision_ = 0;
  // What index_ was made from.
  Medium medium_;
  double depth_error_ = 0.0;

  std::unique_ptr<Visibility> visibility_;
  std::uint64_t visibility_revision_ = 0;
  std::unique_ptr<Occluders> occluders_;

  struct Depths {
    glm::dvec3 light;
    Settings::Arithmetic arithmetic;
    CenterDepths depths;
  };
  struct Table {
    LightTableSize size;
    LightTable table;
    std::vector<TableGaussian> changed = {};  // since it was made
    bool is_patched = false;
  };
  // Pointers, so that references live on when a vector grows.
  std::vector<std::unique_ptr<Depths>> depths_;
  std::vector<std::unique_ptr<Table>> tables_;
  std::vector<std::unique_ptr<ShadowMap>> shadows_;
};

}  // namespace brume
