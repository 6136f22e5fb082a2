#pragma once

#include <cstddef>
#include <vector>

#include "brume/frame.h"
#include "brume/scene.h"
#include "render/quality/center_light.h"

namespace brume {

// Sampling probability of each pixel for estimating a frame's error. They add up to `count`, or to
// the number of pixels if that is smaller.
//
// A mixture: uniform, proportional to the brightness of what is measured of the guide (which
// dominates the relative error), and to its gradient (where methods err). To catch what the guide
// missed, pixels nearest to lights in view are always sampled, and pixels where small Gaussians
// would be brighter than the guide get a share.
std::vector<double> sample_probabilities(const Scene& scene, const Camera& camera,
                                         const Frame& guide, std::size_t count, Measured measured);

}  // namespace brume
