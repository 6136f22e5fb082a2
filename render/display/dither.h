#pragma once

#include <cstdint>

namespace brume {

// Ordered dither: a value in units of the last bit plus the threshold of its pixel, rounded down,
// has the value as its mean over neighbouring pixels. Thresholds are points of the lattice R2
// (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018), whose neighbours are
// spread evenly over (0, 1); in integers, so that the CPU and shaders have the same.
namespace dither {
// 2^32 / p and 2^32 / p^2, where p^3 = p + 1.
constexpr std::uint32_t column_step = 3242174889u;
constexpr std::uint32_t row_step = 2447445414u;
// Values within half of a 256th of an integer are never changed.
constexpr std::uint32_t threshold_bits = 8;
constexpr float threshold_unit = 1.0f / (1u << threshold_bits);
}  // namespace dither

// The threshold of the pixel in a column and row of the whole picture.
inline float dither_threshold(std::uint32_t column, std::uint32_t row) {
  const std::uint32_t place = column * dither::column_step + row * dither::row_step;
  return (static_cast<float>(place >> (32u - dither::threshold_bits)) + 0.5f) *
         dither::threshold_unit;
}

}  // namespace brume
