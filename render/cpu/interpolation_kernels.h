#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

namespace brume {

// The inner loop of interpolating the airlight between samples in single precision (Highway).

// Cells between samples four pixels apart, side by side.
struct CellRow {
  enum class Kind : std::uint8_t {
    uneven,  // not to be interpolated
    solid,   // all four rays end on a surface
    open     // none does
  };
  std::span<const Kind> kinds;  // per cell, at most 32
  // Of the samples above and below, one more than cells: airlight RGB and transmittance, and the
  // distances of their surfaces [u].
  const glm::vec4* above = nullptr;
  const glm::vec4* below = nullptr;
  const float* distances_above = nullptr;
  const float* distances_below = nullptr;
};

// Fills the row of pixels at the share `fy` of the way down the cells, from arrays that begin at
// the first cell's pixel: airlight and transmittance (RGB) of each cell whose four pixels there are
// as distant as interpolated, to `tolerance` [u], or open like the cell. Returns these cells, a bit
// for each; the pixels of the others are left alone.
std::uint32_t interpolate_cells(const CellRow& cells, float fy, float tolerance,
                                const float* distances, float* airlight, float* transmittance);

}  // namespace brume
