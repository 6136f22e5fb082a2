#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "brume/scene.h"
#include "render/geometry/medium_index.h"
#include "render/lighting/optical_depth_table.h"
#include "render/lighting/path_depths.h"
#include "render/lighting/shadow_map.h"
#include "render/render_plan.h"
#include "render/settings.h"
#include "render/visibility/exact_occlusion.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Acceleration structures and per-light caches of a scene. A camera move rebuilds nothing, a moved
// light only its own data, an edit of the medium what depends on the medium.
class PreparedScene {
 public:
  // Brings medium and surfaces up to date and drops the caches of lights that are not the plan's.
  // If memory runs out, stale data is dropped as well.
  void update(const Scene& scene, const RenderPlan& plan);

  // State after the last update().
  [[nodiscard]] const MediumIndex& medium() const { return *index_; }
  // Whether it has fewer Gaussians than the scene, see Settings::merge_error.
  [[nodiscard]] bool is_merged() const { return is_merged_; }
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
  // What index_ is made from.
  struct IndexInputs {
    Revision medium = 0;
    double depth_error = 0.0;
    double merge_error = 0.0;
    double anisotropy = 0.0;

    bool operator==(const IndexInputs&) const = default;
  };

  std::unique_ptr<MediumIndex> index_;
  IndexInputs index_inputs_;
  bool is_merged_ = false;

  std::unique_ptr<RayCaster> ray_caster_;
  std::unique_ptr<ExactOcclusion> exact_occlusion_;

  struct Depths {
    glm::dvec3 light;
    Settings::Precision precision;
    CenterDepths depths;
  };
  struct Table {
    OpticalDepthTableSize size;
    OpticalDepthTable table;
  };
  // Pointers, to keep references valid when a vector grows.
  std::vector<std::unique_ptr<Depths>> depths_;
  std::vector<std::unique_ptr<Table>> tables_;
  std::vector<std::unique_ptr<ShadowMap>> shadows_;
};

}  // namespace brume
