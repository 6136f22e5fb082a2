#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/medium_index.h"
#include "render/settings.h"

namespace brume {

// Optical depths of Gaussians from one point (an eye or a light) to many: T(o, x_k), and
// Tbar_k(o, b_k) where the Gaussian at the end of the path is left out. b0 is not part of them.
//
// Paths are taken in bundles; a bundle finds the Gaussians that reach into its cone in the
// medium's tree, so n Gaussians whose paths meet k others in all cost O(n log n + k).

// One bundle of paths: their ends should be close to each other as seen from the origin.
// self[k] is the Gaussian to leave out of path k, or -1. depths[k] receives the result.
// Returns the number of Gaussian x path pairs evaluated. Thread-safe.
std::uint64_t bundle_depths(const MediumIndex& medium, const glm::dvec3& origin,
                            std::span<const glm::dvec3> ends, std::span<const std::int32_t> self,
                            Settings::Arithmetic arithmetic, std::span<double> depths);

struct CenterDepths {
  std::vector<double> depths;  // per Gaussian: Tbar_i(origin, b_i)
  std::uint64_t pairs = 0;
};

// Tbar_i(origin, b_i) of every Gaussian, in parallel.
CenterDepths center_depths(const MediumIndex& medium, const glm::dvec3& origin,
                           Settings::Arithmetic arithmetic);

}  // namespace brume
