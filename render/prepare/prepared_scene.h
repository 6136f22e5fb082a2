#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

#include "brume/revision.h"
#include "brume/scene.h"
#include "render/geometry/medium_index.h"
#include "render/optical_depth/optical_depth_table.h"
#include "render/optical_depth/path_depths.h"
#include "render/prepare/merged_medium.h"
#include "render/render_plan.h"
#include "render/settings.h"
#include "render/slices/shadow_map.h"
#include "render/visibility/exact_occlusion.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Acceleration structures and per-light caches of a scene. A camera move rebuilds nothing, a moved
// light only its own data, an edit of the medium what depends on the medium.
class PreparedScene {
 public:
  // Brings medium and surfaces up to date and drops the caches of lights that are not the plan's.
  // If memory runs out, stale data is dropped as well. False if stopped. `fog`: where homogeneous
  // fog is, see FogExtent::fog(); `channels`: see RayCaster.
  bool update(const Scene& scene, const RenderPlan& plan, const FogBall& fog = {},
              const std::stop_token& stop = {},
              const glm::dvec3& channels = RayCaster::all_channels);

  // State after the last update().
  [[nodiscard]] const MediumIndex& medium() const { return *media_[current_].index; }
  // The Gaussians it is of: the scene's, or where is_merged() fewer, see Settings::merge_error.
  [[nodiscard]] const Medium& gaussians() const { return media_[current_].merged.medium(); }
  [[nodiscard]] bool is_merged() const { return media_[current_].merged.is_merged(); }
  [[nodiscard]] const RayCaster& ray_caster() const { return *ray_caster_; }
  [[nodiscard]] const ExactOcclusion& exact_occlusion() const {
    return *exact_occlusion_;
  }  // used by the reference only

  // Built on first use; evaluated pairs are added to `pairs`. References are valid until the next
  // update().
  const CenterDepths& light_depths(const glm::dvec3& light, Settings::Precision precision,
                                   std::uint64_t& pairs);
  const OpticalDepthTable& optical_depth_table(const glm::dvec3& light,
                                               const OpticalDepthTableSize& size,
                                               std::uint64_t& pairs);
  const ShadowMap& shadow_map(const glm::dvec3& light, const DirectionMap& map);

 private:
  struct Depths {
    glm::dvec3 light;
    Settings::Precision precision;
    CenterDepths depths;
  };
  struct Table {
    OpticalDepthTableSize size;
    OpticalDepthTable table;
  };
  // A medium at the precision of some settings.
  struct PreparedMedium {
    struct Precision {
      double depth_error = 0.0;
      MergedMedium::Limits merging;
      double anisotropy = 0.0;

      bool operator==(const Precision&) const = default;
    };
    Precision precision;
    MergedMedium merged;
    Revision indexed = 0;  // of `merged`
    std::unique_ptr<MediumIndex> index;
    // Pointers, to keep references valid when a vector grows.
    std::vector<std::unique_ptr<Depths>> depths;
    std::vector<std::unique_ptr<Table>> tables;
  };
  // The second: see Motion::has_own_medium.
  std::array<PreparedMedium, 2> media_;
  std::size_t current_ = 0;

  std::shared_ptr<const RayCaster> ray_caster_;
  std::unique_ptr<ExactOcclusion> exact_occlusion_;
  std::vector<std::unique_ptr<ShadowMap>> shadows_;
};

}  // namespace brume
