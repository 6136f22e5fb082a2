#include "render/prepared_scene.h"

#include <algorithm>

namespace brume {
namespace {

// See Settings::depth_error.
constexpr double reference_depth_error = 1e-8;

}  // namespace

void PreparedScene::update(const Scene& scene, std::span<const PointLight> lights,
                           const Settings& settings) {
  const bool is_reference = settings.airlight == AirlightMethod::reference;
  const double depth_error = is_reference ? reference_depth_error : settings.depth_error;
  if (!index_ || depth_error_ != depth_error || index_->anisotropy() != scene.optics.anisotropy ||
      !(medium_ == scene.medium)) {
    index_.reset();
    depths_.clear();
    tables_.clear();
    medium_ = scene.medium;
    depth_error_ = depth_error;
    index_ = std::make_unique<MediumIndex>(scene.medium, depth_tolerance(scene.medium, depth_error),
                                           scene.optics.anisotropy);
  }
  if (!visibility_ || !visibility_->shows(scene.surfaces)) {
    visibility_.reset();
    occluders_.reset();
    shadows_.clear();
    visibility_ = std::make_unique<Visibility>(scene.surfaces);
  }
  if (!occluders_ && is_reference) occluders_ = std::make_unique<Occluders>(scene.surfaces);

  const auto gone = [&](const glm::dvec3& position) {
    return std::none_of(lights.begin(), lights.end(),
                        [&](const PointLight& light) { return light.position == position; });
  };
  std::erase_if(depths_, [&](const auto& known) { return gone(known->light); });
  std::erase_if(tables_, [&](const auto& known) {
    return gone(known->table.light()) || !(known->size == settings.light_table);
  });
  std::erase_if(shadows_, [&](const auto& known) { return gone(known->light()); });
}

const CenterDepths& PreparedScene::light_depths(const glm::dvec3& light,
                                                Settings::Arithmetic arithmetic,
                                                std::uint64_t& pairs) {
  for (const auto& known : depths_) {
    if (known->light == light && known->arithmetic == arithmetic) return known->depths;
  }
  depths_.push_back(
      std::make_unique<Depths>(light, arithmetic, center_depths(*index_, light, arithmetic)));
  pairs += depths_.back()->depths.pairs;
  return depths_.back()->depths;
}

const LightTable& PreparedScene::light_table(const glm::dvec3& light, const LightTableSize& size,
                                             std::uint64_t& pairs) {
  for (const auto& known : tables_) {
    if (known->table.light() == light && known->size == size) return known->table;
  }
  tables_.push_back(std::make_unique<Table>(size, LightTable(*index_, light, size)));
  pairs += tables_.back()->table.pairs;
  return tables_.back()->table;
}

const ShadowMap& PreparedScene::shadow_map(const glm::dvec3& light, const DirectionMap& map) {
  for (const auto& known : shadows_) {
    if (known->light() == light && known->map() == map) return *known;
  }
  std::erase_if(shadows_, [&](const auto& known) { return known->light() == light; });
  shadows_.push_back(std::make_unique<ShadowMap>(*visibility_, light, map));
  return *shadows_.back();
}

}  // namespace brume
