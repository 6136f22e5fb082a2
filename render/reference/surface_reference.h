#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "core/scene/scene.h"
#include "render/cpu/visibility.h"

namespace brume {

// The light that a surface point sends to the eye, by unbiased Monte Carlo integration: what the
// spherical harmonics and point spread functions of section 4 of the paper are held against. Light
// comes straight through the medium, or is scattered in it once; then the surface reflects it.
// Plain double, exact optical depths, no culling.

struct ReflectedLight {
  glm::dvec3 attenuated{0.0};  // of the light that came straight, RGB radiance
  glm::dvec3 scattered{0.0};   // of the light that was scattered once
  glm::dvec3 error{0.0};       // standard error of their sum
};

struct SurfaceSampling {
  std::size_t samples = 10000;  // >= 2, of each light and of the environment
  std::uint64_t seed = 1;
  // The medium fills a ball of this radius around the point [u]; lights and Gaussians lie in it. A
  // homogeneous medium without end would hide every environment.
  double far = std::numeric_limits<double>::infinity();
};

// Radiance from `point` towards point.to_eye, before the medium between them; without noise from
// point lights that come straight. The error falls like 1 / sqrt(samples). Scene gives medium,
// optics, lights and environment (none: null map), `visibility` its surfaces. Thread-safe.
ReflectedLight reflected_light(const Scene& scene, const Visibility& visibility,
                               const SurfacePoint& point, const SurfaceSampling& sampling);

}  // namespace brume
