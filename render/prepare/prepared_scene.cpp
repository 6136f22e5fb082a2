#include "render/prepare/prepared_scene.h"

#include <algorithm>

#include "core/medium/medium_edit.h"

namespace brume {
namespace {

// A medium's index, and the ids of its Gaussians.
struct IndexedIds {
  const MediumIndex& index;
  std::span<const GaussianId> ids;

  [[nodiscard]] TableGaussian gaussian(GaussianId id) const {
    const auto it = std::ranges::lower_bound(ids, id);
    return {index, static_cast<std::size_t>(it - ids.begin())};
  }
};

// The Gaussians of an edit, before and after it.
std::vector<TableGaussian> table_gaussians(const MediumEdit& edit, const IndexedIds& before,
                                           const IndexedIds& after) {
  std::vector<TableGaussian> gaussians;
  for (const auto& entry : edit.removed()) gaussians.push_back(before.gaussian(entry.id));
  for (const auto& entry : edit.added()) gaussians.push_back(after.gaussian(entry.id));
  for (const auto& change : edit.changed()) {
    gaussians.push_back(before.gaussian(change.id));
    gaussians.push_back(after.gaussian(change.id));
  }
  return gaussians;
}

}  // namespace

// Adds the edits since the last medium to what is pending, or drops the tables that they change too
// much.
void PreparedScene::update_tables(const Medium& medium, const MediumIndex& index,
                                  const IndexInputs& inputs) {
  const auto edit = medium.edit_since(index_inputs_.medium);
  if (!index_ || !edit || inputs.depth_error != index_inputs_.depth_error) {
    tables_.clear();
    return;
  }
  const std::vector<TableGaussian> changed =
      table_gaussians(*edit, {*index_, ids_}, {index, medium.ids()});
  for (const auto& entry : tables_) {
    entry->changed.insert(entry->changed.end(), changed.begin(), changed.end());
  }
  // Where much has changed, a new table is soon made.
  std::erase_if(tables_,
                [&](const auto& entry) { return entry->changed.size() > medium.size() / 4 + 2; });
}

void PreparedScene::update(const Scene& scene, const RenderPlan& plan) {
  const Settings& settings = plan.settings;
  const IndexInputs inputs{scene.medium.revision(), plan.depth_error, scene.optics.anisotropy};
  if (!index_ || inputs != index_inputs_) {
    depths_.clear();
    auto index = std::make_unique<MediumIndex>(
        scene.medium, culling_tolerance(scene.medium, inputs.depth_error), inputs.anisotropy);
    if (settings.patch_light_tables) {
      update_tables(scene.medium, *index, inputs);
    } else {
      tables_.clear();
    }
    ids_.assign(scene.medium.ids().begin(), scene.medium.ids().end());
    index_ = std::move(index);
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
    return is_unused(entry->table.light()) || !(entry->size == settings.optical_depth_table) ||
           // Changes may be pending of a frame that was stopped.
           (!settings.patch_light_tables && (entry->is_patched || !entry->changed.empty()));
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
      std::make_unique<Depths>(light, precision, center_depths(*index_, light, precision)));
  pairs += depths_.back()->depths.pairs;
  return depths_.back()->depths;
}

const OpticalDepthTable& PreparedScene::optical_depth_table(const glm::dvec3& light,
                                                            const OpticalDepthTableSize& size,
                                                            std::uint64_t& pairs) {
  const auto it = std::find_if(tables_.begin(), tables_.end(), [&](const auto& t) {
    return t->table.light() == light && t->size == size;
  });
  if (it != tables_.end()) {
    Table& entry = **it;
    if (entry.changed.empty()) return entry.table;
    const std::vector<TableGaussian> changed = std::move(entry.changed);
    entry.changed.clear();
    if (entry.table.update(*index_, changed)) {
      entry.is_patched = true;
      pairs += entry.table.pairs;
      return entry.table;
    }
    tables_.erase(it);
  }
  tables_.push_back(std::make_unique<Table>(size, OpticalDepthTable(*index_, light, size)));
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
