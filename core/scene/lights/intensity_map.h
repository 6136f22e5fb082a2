#pragma once

#include <vector>

namespace brume {

// Relative intensities by direction for fast look-ups: side x side values, rows one after the
// other, to be interpolated in both coordinates.
struct IntensityMap {
  int side = 0;                 // >= 2
  std::vector<float> values{};  // in [0, 1]
  // Whether its square is that around a cone, cut across the axis, from -1 to 1 along the azimuths
  // 0 and 90; else it is an octahedron: (x, y) / (|x| + |y| + |z|), folded over the diagonals for
  // z < 0.
  bool is_around_cone = false;
};

}  // namespace brume
