#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/cpu/direction_map.h"
#include "render/medium_index.h"
#include "render/settings.h"

namespace brume {

// A Gaussian as a table sees it.
struct TableGaussian {
  glm::dvec3 center{0.0};
  double core = 0.0;   // what the map is laid out for [u]
  double reach = 0.0;  // where it matters at all [u]; 0: nowhere

  TableGaussian(const MediumIndex& medium, std::size_t index);
};

// The radii of a table: even, or ever wider the farther from the light where a few Gaussians are
// much larger than the others. Radius r is number per_unit x / (1 + bend x), x = r - first.
struct TableRadii {
  int count = 0;
  double first = 0.0;     // [u]
  double per_unit = 0.0;  // [1/u]
  double bend = 0.0;      // [1/u]; 0: even

  TableRadii() = default;
  // From first to last; half of them up to first + `half`, if that is not half of the way or more.
  TableRadii(int count_, double first_, double last, double half);

  [[nodiscard]] double radius(int k) const;
  [[nodiscard]] double last() const { return radius(count - 1); }
};

// Which directions and radii a table covers.
struct LightTableLayout {
  DirectionMap map;
  TableRadii radii;

  LightTableLayout() = default;
  LightTableLayout(const MediumIndex& medium, const glm::dvec3& light, const LightTableSize& size);

  // No Gaussian reaches anything.
  [[nodiscard]] bool empty() const { return radii.count == 0; }
};

// T(s, x) of the Gaussians around one light, tabulated over directions and radii and interpolated
// linearly in all three. Depths are stored in 16 bits, in even steps up to a little above the
// greatest one or to `opaque`, so that exp(-T) is off by 2.3e-4 at most. The map of directions is a
// perspective one towards the medium when the light is outside it, octahedral (all directions) when
// it is inside or close. b0 is not part of it: its share is known exactly.
class LightTable {
 public:
  // Nothing comes through more than this: exp(-30) = 1e-13.
  static constexpr float opaque = 30.0f;

  // In parallel. Cost: directions^2 * (Gaussians that a direction meets) line integrals.
  LightTable(const MediumIndex& medium, const glm::dvec3& light, const LightTableSize& size);

  // Makes anew only the directions in which Gaussians have changed, given as they were and as they
  // are; `medium` has them as they are. False if that is not enough, because one of them lies
  // outside what the table covers or is too dense for it; the table is then of no more use.
  bool update(const MediumIndex& medium, std::span<const TableGaussian> changed);

  [[nodiscard]] const glm::dvec3& light() const { return light_; }
  [[nodiscard]] const DirectionMap& map() const { return layout_.map; }
  // No Gaussian reaches anything.
  [[nodiscard]] bool empty() const { return depths_.empty(); }

  // What a look-up needs; see slice_kernels.cpp. Depths of one direction lie together, directions
  // in rows of map.stride().
  struct View {
    const std::uint16_t* depths = nullptr;
    float unit = 0.0f;  // the depth that 1 stands for
    DirectionMap map;
    int radii = 0;
    float first_radius = 0.0f, radii_per_unit = 0.0f, bend = 0.0f;  // see TableRadii
  };
  [[nodiscard]] View view() const;

  std::uint64_t pairs = 0;  // Gaussian x ray pairs evaluated when it was last made or updated

 private:
  // Some neighbouring directions, whose rays share a list of Gaussians.
  struct Block {
    std::vector<glm::dvec3> ends;
    std::vector<std::size_t> cells;
  };
  [[nodiscard]] int blocks_across() const;
  [[nodiscard]] int blocks_down() const;
  [[nodiscard]] Block block(int index) const;
  // Calls store(cell, depths at all radii) for the cells of a block.
  template <class Store>
  std::uint64_t find_depths(const MediumIndex& medium, const Block& part, Store store) const;
  [[nodiscard]] std::uint16_t stored(float depth) const;

  glm::dvec3 light_;
  LightTableLayout layout_;
  float unit_ = 0.0f;
  std::vector<std::uint16_t> depths_;
};

}  // namespace brume
