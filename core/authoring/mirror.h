#pragma once

#include <vector>

#include "core/medium/gaussian.h"
#include "core/scene/brush.h"

namespace brume {

// A Gaussian and its mirror images: 2^n of them for n planes, itself first, also where they
// coincide.
std::vector<Gaussian> mirror_images(const Gaussian& gaussian, const MirrorPlanes& planes);

}  // namespace brume
