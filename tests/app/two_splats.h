#pragma once

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <vector>

#include "core/io/gaussians/gaussian_file.h"

namespace brume {

// Two ellipsoids of one shape as splats whose opacity is that along the longest radius.
inline std::vector<Gaussian> write_two_splats(const std::filesystem::path& file,
                                              const glm::dvec3& center) {
  Gaussian g{center, 1.0, 0.5};
  g.set_radii({1.0, 0.5, 0.25}, {0.8, 0.6, 0.0, 0.0});
  Gaussian other = g;
  other.center.y += 1.0;
  write_splats(file, std::vector{g, other}, {.along = OpacityAlong::longest});
  return {g, other};
}

// Whether it is that Gaussian, turned by half about z.
inline bool is_half_turned(const Gaussian& found, const Gaussian& g) {
  return glm::length(found.center - glm::dvec3(-g.center.x, -g.center.y, g.center.z)) < 1e-6 &&
         glm::length(found.radii() - g.radii()) < 1e-6 &&
         std::abs(found.density - g.density) < 1e-6;
}

}  // namespace brume
