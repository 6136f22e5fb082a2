#include "render/prepare/prepared_scene.h"

#include <algorithm>

namespace brume {
bool PreparedScene::update(const Scene& scene, const RenderPlan& plan, const FogBall& fog,
                           const std::stop_token& stop, const glm::dvec3& channels) {
  const Settings& settings = plan.settings;
  MergedMedium::Limits merging;
  if (MergedMedium::may_merge(scene.medium)) {
    // In motion merged parts may rather be those of an earlier frame than late.
    merging = {plan.merge_error, settings.merge_share, plan.motion.has_own_medium ? 0.5 : 0.0};
  }
  const PreparedMedium::Precision precision{plan.depth_error, merging, scene.optics.anisotropy};
  current_ = plan.motion.has_own_medium ? 1 : 0;
  PreparedMedium& prepared = media_[current_];
  if (prepared.precision != precision) prepared = {};
  prepared.precision = precision;
  if (!prepared.merged.update(scene.medium, precision.merging, stop)) return false;
  const Medium& medium = prepared.merged.medium();
  if (!prepared.index || prepared.indexed != medium.revision()) {
    prepared.depths.clear();
    prepared.tables.clear();
    prepared.index = std::make_unique<MediumIndex>(
        medium, culling_tolerance(medium, precision.depth_error), precision.anisotropy);
    prepared.indexed = medium.revision();
  }
  prepared.index->set_noise(RayNoise(scene.optics.noise, scene.time));
  prepared.index->set_fog(fog);
  if (!ray_caster_ || !ray_caster_->shows(scene.surfaces, channels)) {
    ray_caster_.reset();
    exact_occlusion_.reset();
    shadows_.clear();
    ray_caster_ = shared_ray_caster(scene.surfaces, channels);
  }
  if (!exact_occlusion_ && plan.has_exact_occlusion)
    exact_occlusion_ = std::make_unique<ExactOcclusion>(scene.surfaces);

  const auto is_unused = [&](const glm::dvec3& position) {
    return std::ranges::find(plan.lights, position, &PointLight::position) == plan.lights.end();
  };
  for (PreparedMedium& each : media_) {
    std::erase_if(each.depths, [&](const auto& entry) { return is_unused(entry->light); });
    std::erase_if(each.tables, [&](const auto& entry) { return is_unused(entry->table.light()); });
  }
  std::erase_if(prepared.tables,
                [&](const auto& entry) { return !(entry->size == settings.optical_depth_table); });
  std::erase_if(shadows_, [&](const auto& entry) { return is_unused(entry->light()); });
  return true;
}

const CenterDepths& PreparedScene::light_depths(const glm::dvec3& light,
                                                Settings::Precision precision,
                                                std::uint64_t& pairs) {
  std::vector<std::unique_ptr<Depths>>& depths = media_[current_].depths;
  for (const auto& entry : depths) {
    if (entry->light == light && entry->precision == precision) return entry->depths;
  }
  depths.push_back(std::make_unique<Depths>(
      Depths{light, precision, center_depths(medium(), light, precision)}));
  pairs += depths.back()->depths.pairs;
  return depths.back()->depths;
}

const OpticalDepthTable& PreparedScene::optical_depth_table(const glm::dvec3& light,
                                                            const OpticalDepthTableSize& size,
                                                            std::uint64_t& pairs) {
  std::vector<std::unique_ptr<Table>>& tables = media_[current_].tables;
  for (const auto& entry : tables) {
    if (entry->table.light() == light && entry->size == size) return entry->table;
  }
  tables.push_back(std::make_unique<Table>(Table{size, OpticalDepthTable(medium(), light, size)}));
  pairs += tables.back()->table.pairs;
  return tables.back()->table;
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
