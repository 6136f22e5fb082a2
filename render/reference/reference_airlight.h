#pragma once

#include <span>

#include "core/scene/scene.h"
#include "render/medium_index.h"
#include "render/reference/environment_integral.h"
#include "render/reference/occluders.h"

namespace brume {

// The converged airlight of one view ray in a scene: every light, b0, Gaussians, and surfaces as
// blockers of the lights on their way through the medium; and the environment, which no surface
// blocks.

struct ReferenceLight {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};  // RGB [W/sr]
  double h_min = 0.0;         // see light_limits.h [u]
};

struct ReferenceRay {
  glm::dvec3 airlight{0.0};  // RGB radiance
  double depth = 0.0;        // T(v, p), b0 included; +inf possible
  std::uint64_t view_pairs = 0;
  std::uint64_t light_pairs = 0;
};

// `length` is the distance to the first surface or +inf; `environment`: null if there is none;
// `tolerance` the relative one of airlight_integral(). Thread-safe.
ReferenceRay reference_airlight(const MediumIndex& medium, const Occluders& occluders,
                                std::span<const ReferenceLight> lights,
                                const ReferenceEnvironment* environment, const glm::dvec3& eye,
                                const glm::dvec3& w, double length, double tolerance);

}  // namespace brume
