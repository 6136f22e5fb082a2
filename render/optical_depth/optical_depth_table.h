#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "brume/revision.h"
#include "render/geometry/direction_map.h"
#include "render/geometry/medium_index.h"
#include "render/settings.h"

namespace brume {

// A Gaussian as seen by a table.
struct TableGaussian {
  glm::dvec3 center{0.0};
  double core = 0.0;           // radius that the map must cover [u]
  double cutoff_radius = 0.0;  // cutoff radius [u]; 0: culled

  TableGaussian(const MediumIndex& medium, std::size_t index);
};

// Sample radii of a table: uniform, or with spacing growing with distance where a few Gaussians are
// much larger than the others. Radius r has index per_unit x / (1 + bend x), x = r - first.
struct TableRadii {
  int count = 0;
  double first = 0.0;      // [u]
  double per_unit = 0.0;   // [1/u]
  double curvature = 0.0;  // 0: uniform

  TableRadii() = default;
  // From first to last; half of the samples within first + `half`, unless that is beyond the
  // middle.
  TableRadii(int count_, double first_, double last, double half);

  [[nodiscard]] double radius(int k) const;
  [[nodiscard]] double last() const { return radius(count - 1); }
};

// Directions and radii covered by a table.
struct OpticalDepthTableLayout {
  DirectionMap map;
  TableRadii radii;

  OpticalDepthTableLayout() = default;
  OpticalDepthTableLayout(const MediumIndex& medium, const glm::dvec3& light,
                          const OpticalDepthTableSize& size);

  // No Gaussian reaches anything.
  [[nodiscard]] bool empty() const { return radii.count == 0; }
};

// Optical depth T(s, x) of the Gaussians around a point light, tabulated over directions and radii,
// trilinearly interpolated (kin of deep shadow maps). Stored in 16 bits, in uniform steps up to
// slightly above the maximum or `opaque`, so exp(-T) is off by at most 2.3e-4. The direction map is
// perspective if the light is outside the medium, octahedral if inside or close. b0 is excluded:
// its part is analytic.
class OpticalDepthTable {
 public:
  // Optical depths are clamped to this: exp(-30) = 1e-13.
  static constexpr float opaque = 30.0f;

  // In parallel. Cost: directions^2 * (Gaussians per direction) line integrals.
  OpticalDepthTable(const MediumIndex& medium, const glm::dvec3& light,
                    const OpticalDepthTableSize& size);
  // A table of a light whose parts are at these offsets, all alike: exp(-T) is their mean, each
  // towards as far away in the same direction.
  OpticalDepthTable(const MediumIndex& medium, const glm::dvec3& light,
                    std::span<const glm::dvec3> parts, const OpticalDepthTableSize& size);

  [[nodiscard]] Revision revision() const { return revision_; }
  [[nodiscard]] const glm::dvec3& light() const { return light_; }
  [[nodiscard]] const DirectionMap& map() const { return layout_.map; }
  // No Gaussian reaches anything.
  [[nodiscard]] bool empty() const { return depths_.empty(); }

  // Data for look-ups; see slice_kernels.cpp. Radii of one direction are contiguous, directions are
  // rows of map.stride().
  struct View {
    const std::uint16_t* depths = nullptr;
    float unit = 0.0f;  // optical depth per integer step
    DirectionMap map;
    int radii = 0;
    float first_radius = 0.0f, radii_per_unit = 0.0f, curvature = 0.0f;  // see TableRadii
  };
  [[nodiscard]] View view() const;

  std::uint64_t pairs = 0;  // Gaussian x ray pairs evaluated

 private:
  Revision revision_ = new_revision();
  // Neighbouring directions that share a list of Gaussians.
  struct Block {
    std::vector<glm::dvec3> ends;  // from the light [u]
    std::vector<std::size_t> cells;
  };
  [[nodiscard]] int blocks_across() const;
  [[nodiscard]] int blocks_down() const;
  [[nodiscard]] Block block_at(int index) const;
  // Calls store(cell, optical depths at all radii) for the cells of a block, from a part of the
  // light.
  template <class Store>
  std::uint64_t find_depths(const MediumIndex& medium, const glm::dvec3& part, const Block& block,
                            Store store) const;
  [[nodiscard]] std::uint16_t stored(float depth) const;

  glm::dvec3 light_;
  OpticalDepthTableLayout layout_;
  float unit_ = 0.0f;
  std::vector<std::uint16_t> depths_;
};

}  // namespace brume
