#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "render/grid/grid_occlusion.h"
#include "render/scattering/node_visibility.h"
#include "render/scattering/source_grid.h"

namespace brume {

// A level of a SourceGrid relative to a point.
struct GridLevel {
  glm::vec3 first{0.0f};  // node 0 [u]
  float per_unit = 1.0f;  // nodes [1/u]
  glm::ivec3 count{2};
  const float* values = nullptr;
  const float* incident = nullptr;
  const std::uint32_t* blocked = nullptr;  // GridOcclusion::hidden(); null: no surfaces
  std::uint32_t occlusion_bits = GridOcclusion::all_bits;
  NodeVisibility::Layers eye_layers;
  const float* view = nullptr;  // see SourceLookup::set_view()
  float view_begin = 0.0f;      // distance from where it is used [u]
};

// Those of a grid, fine first. Keeps a reference to it.
class GridLevels {
 public:
  GridLevels(const SourceGrid& grid, const glm::dvec3& origin, const NodeVisibility& visibility);

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::span<GridLevel> all() { return std::span(levels_).first(count_); }
  [[nodiscard]] std::span<const GridLevel> all() const { return std::span(levels_).first(count_); }

 private:
  std::array<GridLevel, SourceGrid::max_levels> levels_;
  std::size_t count_ = 0;
};

}  // namespace brume
