#pragma once

#include <array>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

// Planes through a point, across the axes that are true.
struct MirrorPlanes {
  std::array<bool, 3> axes{};
  glm::dvec3 center{0.0};

  bool operator==(const MirrorPlanes&) const = default;
};

// A Gaussian and its mirror images: 2^n of them for n planes, itself first, also where they
// coincide.
std::vector<Gaussian> mirror_images(const Gaussian& gaussian, const MirrorPlanes& planes);

}  // namespace brume
