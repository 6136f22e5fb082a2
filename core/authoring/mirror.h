#pragma once

#include <vector>

#include "brume/brush.h"
#include "brume/gaussian.h"

namespace brume {

// A Gaussian and its mirror images: 2^n of them for n planes, itself first, also where they
// coincide.
std::vector<Gaussian> mirror_images(const Gaussian& gaussian, const MirrorPlanes& planes);

}  // namespace brume
