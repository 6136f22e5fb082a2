#pragma once

#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "render/geometry/direction_map.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// A cell of a shadow map stands for its neighbourhood, where a slanting surface is nearer and
// farther by about the cells' width: this share of a point's distance from the light behind the
// surface is still lit, or all surfaces would be darkened.
inline float shadow_bias(const DirectionMap& map) {
  return 2.0f * static_cast<float>(map.cell_angle());
}

// Shadow maps of full spheres hold distances. Others hold depths along the map's axis from this
// depth on, that of the surfaces' center: at a far light's distance float has no digits.
inline double shadow_start(const DirectionMap& map, const glm::dvec3& light,
                           const glm::dvec3& center) {
  return map.octahedral ? 0.0 : glm::dot(center - light, glm::dvec3(map.axis));
}

// Shadow map of a point light: depth of the first surface per direction, for shadows of surfaces in
// the medium (light shafts). Traced in parallel by Embree.
class ShadowMap {
 public:
  ShadowMap(const RayCaster& ray_caster, const glm::dvec3& light, const DirectionMap& map);

  [[nodiscard]] const glm::dvec3& light() const { return light_; }
  [[nodiscard]] const DirectionMap& map() const { return map_; }
  // No surfaces.
  [[nodiscard]] bool empty() const { return depths_.empty(); }
  [[nodiscard]] double start() const { return start_; }  // shadow_start()
  // Rows of map().stride() depths [u], +inf where nothing is hit.
  [[nodiscard]] const float* depths() const { return depths_.data(); }
  // Minimum, of panes too, and maximum over each 2 x 2 footprint of bilinear interpolation.
  struct Range {
    float min_depth, max_depth;
  };
  [[nodiscard]] const Range* ranges() const { return ranges_.data(); }
  // The n-th panes before that, by direction: their depths, +inf for none, and the share of light
  // that they let through.
  struct PaneLayer {
    std::vector<float> depths, passing;
  };
  [[nodiscard]] const std::vector<PaneLayer>& panes() const { return panes_; }
  // The last layer has all further ones, too.
  static constexpr std::size_t max_pane_layers = 8;

 private:
  // Makes layers of the panes in each direction, in order of their depths; none: there are none.
  void add_panes(std::span<const std::vector<PaneHit>> panes);
  // The depth of something in the direction of a cell [u].
  [[nodiscard]] float depth(const glm::dvec3& direction, double distance) const;

  glm::dvec3 light_;
  DirectionMap map_;
  double start_ = 0.0;
  std::vector<float> depths_;
  std::vector<Range> ranges_;
  std::vector<PaneLayer> panes_;
};

}  // namespace brume
