#pragma once

#include <span>

#include "brume/scene.h"
#include "render/geometry/medium_index.h"
#include "render/geometry/point_source.h"
#include "render/reference/environment_integral.h"
#include "render/visibility/exact_occlusion.h"

namespace brume {

// The converged airlight of one view ray: all lights with shadows of surfaces, b0 and Gaussians,
// and the environment, which surfaces do not occlude.

struct ReferenceRay {
  glm::dvec3 airlight{0.0};  // RGB radiance
  double depth = 0.0;        // T(v, p), b0 included; +inf possible
  std::uint64_t view_pairs = 0;
  std::uint64_t light_pairs = 0;
};

// `length`: distance to the first surface or +inf; `environment`: may be null; `tolerance`:
// relative, see airlight_integral(). Thread-safe.
ReferenceRay reference_airlight(const MediumIndex& medium, const ExactOcclusion& exact_occlusion,
                                std::span<const PointSource> lights,
                                const ReferenceEnvironment* environment, const glm::dvec3& eye,
                                const glm::dvec3& w, double length, double tolerance);

}  // namespace brume
