#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/scene.h"
#include "render/frame.h"

namespace brume {

// Gaussians that are a few pixels large at most, which a picture may lose: the pixel nearest to the
// centre of each that is in view, by its index by row from the top, and how much the Gaussian may
// change of it: a radiance, estimated as if nothing else were there to dim it.
struct SmallGaussian {
  std::size_t pixel;
  double change;
};

// Those that may change the guide by at least `least` > 0, the one that may most first; as many as
// `most`.
std::vector<SmallGaussian> small_gaussians(const Scene& scene, const CameraRays& rays,
                                           const Frame& guide, double least, std::size_t most);

}  // namespace brume
