#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/scene.h"
#include "render/frame.h"

namespace brume {

// Where a sample of a view's pixels has to look so that its error is not missed: the probability of
// each pixel of being met. They add up to `count`, or to all pixels if those are fewer.
//
// Some of the sample goes evenly over all pixels, some where the guide is bright, since that is how
// pixels count in a relative error, and some where it is steep, since that is where methods err.
// What the guide may have lost altogether is told by the scene: the pixels nearest to lights in
// view are always met, and some of the sample goes where small Gaussians would be brighter than the
// guide.
std::vector<double> sample_chances(const Scene& scene, const Camera& camera, const Frame& guide,
                                   std::size_t count);

}  // namespace brume
