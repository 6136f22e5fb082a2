#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/settings.h"

namespace brume {

// Optical depths of Gaussians from one point (eye or light) to many: T(o, x_k), and Tbar_k(o, b_k)
// where the Gaussian at the end of the path is excluded. b0 is excluded.
//
// Paths are processed in bundles; a bundle finds the Gaussians that touch its cone in the medium's
// hierarchy: O(n log n + k) for n Gaussians and k pairs.

// One bundle of paths with nearby ends. self[k] is the Gaussian to exclude from path k, or -1.
// Writes depths[k]. Returns the Gaussian x path pairs evaluated. Thread-safe.
std::uint64_t bundle_depths(const MediumIndex& medium, const glm::dvec3& origin,
                            std::span<const glm::dvec3> ends, std::span<const std::int32_t> self,
                            Settings::Precision precision, std::span<double> depths);

struct CenterDepths {
  std::vector<double> depths;  // per Gaussian: Tbar_i(origin, b_i)
  std::uint64_t pairs = 0;
};

// Tbar_i(origin, b_i) of every Gaussian, in parallel.
CenterDepths center_depths(const MediumIndex& medium, const glm::dvec3& origin,
                           Settings::Precision precision);

// The same from the plane through the eye across a unit direction, along that.
CenterDepths parallel_center_depths(const MediumIndex& medium, const glm::dvec3& eye,
                                    const glm::dvec3& direction);

}  // namespace brume
