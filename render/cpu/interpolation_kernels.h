#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

namespace brume {

// SIMD kernel of the airlight's interpolation between samples (Highway, single precision).

// A row of cells between samples four pixels apart.
struct CellRow {
  enum class Kind : std::uint8_t {
    uneven,  // not interpolated
    solid,   // all four corners hit a surface
    open     // none does
  };
  std::span<const Kind> kinds;  // per cell, at most 32
  // Samples above and below, one more than cells: airlight RGB and transmittance, and surface
  // distances [u].
  const glm::vec4* above = nullptr;
  const glm::vec4* below = nullptr;
  const float* distances_above = nullptr;
  const float* distances_below = nullptr;
};

// Fills one row of pixels at fraction `fy` of the cells' height, from arrays that begin at the
// first cell's pixel: airlight and transmittance (RGB) of each cell whose four pixels lie at the
// interpolated distance, to `tolerance` [u], or are open like the cell. Returns a bit mask of these
// cells; pixels of the others are unchanged.
std::uint32_t interpolate_cells(const CellRow& cells, float fy, float tolerance,
                                const float* distances, float* airlight, float* transmittance);

}  // namespace brume
