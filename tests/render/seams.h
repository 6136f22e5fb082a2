#pragma once

#include <vector>
#include "brume/scene.h"

#include "brume/frame.h"

namespace brume {

// Steps in the error of a frame's airlight at borders of tiles and within tiles. Each is the
// mean along the side of a tile.
struct Seams {
  // Absolute values, ascending, relative to the truth's rms.
  std::vector<double> borders, insides;

  void add(const Seams& more);
  // How many times those at borders are those within tiles, at this share of each.
  [[nodiscard]] double ratio(double quantile) const;
};

// A scene of a few Gaussians, lights in and next to them, and sometimes homogeneous fog, noise or a
// ball: the error of its airlight is smooth except at tiles. Deterministic for a seed.
Scene seam_scene(unsigned seed);

// `frame` with its airlight at 1 / `scale`, `truth` of the same view. Where the eye sees edges of
// surfaces, nothing is compared.
Seams find_seams(const Frame& frame, const Frame& reference, int scale);

}  // namespace brume
