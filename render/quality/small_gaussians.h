#pragma once

#include <cstddef>
#include <vector>

#include "brume/frame.h"
#include "brume/scene.h"
#include "core/scene/camera_rays.h"

namespace brume {

// A Gaussian of at most a few pixels, which a frame may miss: the pixel nearest to its center
// (row-major index) and the radiance it may add there, estimated without occlusion.
struct SmallGaussian {
  std::size_t pixel;
  double change;
};

// The Gaussians that may change the guide by at least `min_change` > 0, in descending order, at
// most `max_count`.
std::vector<SmallGaussian> small_gaussians(const Scene& scene, const CameraRays& rays,
                                           const Frame& guide, double min_change,
                                           std::size_t max_count);

}  // namespace brume
