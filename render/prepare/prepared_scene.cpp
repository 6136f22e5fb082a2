#include "render/prepare/prepared_scene.h"

#include <algorithm>

namespace brume {
namespace {

// See Settings::depth_error.
constexpr double reference_depth_error = 1e-8;

// The Gaussians in which two mediums differ: as they are in the one and as they are in the other.
std::vector<TableGaussian> changed_gaussians(const Medium& a, const MediumIndex& index_a,
                                             const Medium& b, const MediumIndex& index_b) {
  std::vector<TableGaussian> changed;
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < a.size() || k < b.size()) {
    const bool in_a = i < a.size() && (k == b.size() || a.ids()[i] <= b.ids()[k]);
    const bool in_b = k < b.size() && (i == a.size() || b.ids()[k] <= a.ids()[i]);
    const bool same = in_a && in_b && a.gaussian(i) == b.gaussian(k);
    if (in_a && !same) changed.emplace_back(index_a, i);
    if (in_b && !same) changed.emplace_back(index_b, k);
    i += in_a ? 1 : 0;
    k += in_b ? 1 : 0;
  }
  return changed;
}

}  // namespace

void PreparedScene::update(const Scene& scene, std::span<const PointLight> lights,
                           const Settings& settings) {
  const bool is_reference = settings.airlight == AirlightMethod::reference;
  const double depth_error = is_reference ? reference_depth_error : settings.depth_error;
  if (!index_ || depth_error_ != depth_error || index_->anisotropy() != scene.optics.anisotropy ||
      !(medium_ == scene.medium)) {
    depths_.clear();
    if (depth_error_ != depth_error) tables_.clear();
    auto index = std::make_unique<MediumIndex>(
        scene.medium, depth_tolerance(scene.medium, depth_error), scene.optics.anisotropy);
    if (!settings.patch_light_tables) tables_.clear();
    const std::vector<TableGaussian> changed =
        tables_.empty() ? std::vector<TableGaussian>{}
                        : changed_gaussians(medium_, *index_, scene.medium, *index);
    for (const auto& known : tables_) {
      known->changed.insert(known->changed.end(), changed.begin(), changed.end());
    }
    // Where much has changed, a new table is soon made.
    std::erase_if(tables_, [&](const auto& known) {
      return known->changed.size() > scene.medium.size() / 4 + 2;
    });
    index_ = std::move(index);
    ++medium_revision_;
    medium_ = scene.medium;
    depth_error_ = depth_error;
  }
  index_->set_noise(RayNoise(scene.optics.noise, scene.time));
  if (!ray_caster_ || !ray_caster_->shows(scene.surfaces)) {
    ray_caster_.reset();
    exact_occlusion_.reset();
    shadows_.clear();
    ray_caster_ = std::make_unique<RayCaster>(scene.surfaces);
    ++surface_revision_;
  }
  if (!exact_occlusion_ && is_reference)
    exact_occlusion_ = std::make_unique<ExactOcclusion>(scene.surfaces);

  const auto gone = [&](const glm::dvec3& position) {
    return std::none_of(lights.begin(), lights.end(),
                        [&](const PointLight& light) { return light.position == position; });
  };
  std::erase_if(depths_, [&](const auto& known) { return gone(known->light); });
  std::erase_if(tables_, [&](const auto& known) {
    return gone(known->table.light()) || !(known->size == settings.optical_depth_table) ||
           // Changes may be pending of a frame that was stopped.
           (!settings.patch_light_tables && (known->is_patched || !known->changed.empty()));
  });
  std::erase_if(shadows_, [&](const auto& known) { return gone(known->light()); });
}

const CenterDepths& PreparedScene::light_depths(const glm::dvec3& light,
                                                Settings::Precision precision,
                                                std::uint64_t& pairs) {
  for (const auto& known : depths_) {
    if (known->light == light && known->precision == precision) return known->depths;
  }
  depths_.push_back(
      std::make_unique<Depths>(light, precision, center_depths(*index_, light, precision)));
  pairs += depths_.back()->depths.pairs;
  return depths_.back()->depths;
}

const OpticalDepthTable& PreparedScene::optical_depth_table(const glm::dvec3& light,
                                                            const OpticalDepthTableSize& size,
                                                            std::uint64_t& pairs) {
  const auto known = std::find_if(tables_.begin(), tables_.end(), [&](const auto& t) {
    return t->table.light() == light && t->size == size;
  });
  if (known != tables_.end()) {
    Table& found = **known;
    if (found.changed.empty()) return found.table;
    const std::vector<TableGaussian> changed = std::move(found.changed);
    found.changed.clear();
    if (found.table.update(*index_, changed)) {
      found.is_patched = true;
      pairs += found.table.pairs;
      return found.table;
    }
    tables_.erase(known);
  }
  tables_.push_back(std::make_unique<Table>(size, OpticalDepthTable(*index_, light, size)));
  pairs += tables_.back()->table.pairs;
  return tables_.back()->table;
}

const ShadowMap& PreparedScene::shadow_map(const glm::dvec3& light, const DirectionMap& map) {
  for (const auto& known : shadows_) {
    if (known->light() == light && known->map() == map) return *known;
  }
  std::erase_if(shadows_, [&](const auto& known) { return known->light() == light; });
  shadows_.push_back(std::make_unique<ShadowMap>(*ray_caster_, light, map));
  return *shadows_.back();
}

}  // namespace brume
