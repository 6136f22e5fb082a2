#include "render/prepare/prepared_scene.h"

#include <algorithm>

#include "render/prepare/merged_medium.h"

namespace brume {
void PreparedScene::update(const Scene& scene, const RenderPlan& plan) {
  const Settings& settings = plan.settings;
  const IndexInputs inputs{scene.medium.revision(), plan.depth_error, plan.merge_error,
                           scene.optics.anisotropy};
  if (!index_ || inputs != index_inputs_) {
    depths_.clear();
    tables_.clear();
    const std::optional<Medium> merged = merged_medium(scene.medium, inputs.merge_error);
    const Medium& medium = merged ? *merged : scene.medium;
    is_merged_ = merged.has_value();
    index_ = std::make_unique<MediumIndex>(medium, culling_tolerance(medium, inputs.depth_error),
                                           inputs.anisotropy);
    index_inputs_ = inputs;
  }
  index_->set_noise(RayNoise(scene.optics.noise, scene.time));
  if (!ray_caster_ || !ray_caster_->shows(scene.surfaces)) {
    ray_caster_.reset();
    exact_occlusion_.reset();
    shadows_.clear();
    ray_caster_ = std::make_unique<RayCaster>(scene.surfaces);
  }
  if (!exact_occlusion_ && plan.has_exact_occlusion)
    exact_occlusion_ = std::make_unique<ExactOcclusion>(scene.surfaces);

  const auto is_unused = [&](const glm::dvec3& position) {
    return std::ranges::find(plan.lights, position, &PointLight::position) == plan.lights.end();
  };
  std::erase_if(depths_, [&](const auto& entry) { return is_unused(entry->light); });
  std::erase_if(tables_, [&](const auto& entry) {
    return is_unused(entry->table.light()) || !(entry->size == settings.optical_depth_table);
  });
  std::erase_if(shadows_, [&](const auto& entry) { return is_unused(entry->light()); });
}

const CenterDepths& PreparedScene::light_depths(const glm::dvec3& light,
                                                Settings::Precision precision,
                                                std::uint64_t& pairs) {
  for (const auto& entry : depths_) {
    if (entry->light == light && entry->precision == precision) return entry->depths;
  }
  depths_.push_back(
      std::make_unique<Depths>(Depths{light, precision, center_depths(*index_, light, precision)}));
  pairs += depths_.back()->depths.pairs;
  return depths_.back()->depths;
}

const OpticalDepthTable& PreparedScene::optical_depth_table(const glm::dvec3& light,
                                                            const OpticalDepthTableSize& size,
                                                            std::uint64_t& pairs) {
  for (const auto& entry : tables_) {
    if (entry->table.light() == light && entry->size == size) return entry->table;
  }
  tables_.push_back(std::make_unique<Table>(Table{size, OpticalDepthTable(*index_, light, size)}));
  pairs += tables_.back()->table.pairs;
  return tables_.back()->table;
}

const ShadowMap& PreparedScene::shadow_map(const glm::dvec3& light, const DirectionMap& map) {
  for (const auto& entry : shadows_) {
    if (entry->light() == light && entry->map() == map) return *entry;
  }
  std::erase_if(shadows_, [&](const auto& entry) { return entry->light() == light; });
  shadows_.push_back(std::make_unique<ShadowMap>(*ray_caster_, light, map));
  return *shadows_.back();
}

}  // namespace brume
