#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "brume/scene.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Outgoing radiance of a surface point by unbiased Monte Carlo integration: ground truth for the
// spherical harmonics and point spread functions of section 4 of the paper. Light arrives directly
// or scattered once. Double precision, exact optical depths, no culling.

struct ReflectedLight {
  glm::dvec3 attenuated{0.0};  // from direct light, RGB radiance
  glm::dvec3 scattered{0.0};   // from light scattered once
  glm::dvec3 error{0.0};       // standard error of their sum
};

struct SurfaceSampling {
  std::size_t samples = 10000;  // >= 2, per light and for the environment
  std::uint64_t seed = 1;
  // The medium is limited to a ball of this radius around the point [u]; lights and Gaussians lie
  // inside. Infinite fog would hide any environment.
  double far = std::numeric_limits<double>::infinity();
};

// Radiance from `point` towards point.to_eye, before attenuation towards the eye; direct light of
// point lights is noise-free. The error falls like 1 / sqrt(samples). Uses medium, optics, lights
// and environment of the scene (null map: none), and the surfaces of `ray_caster`. Thread-safe.
ReflectedLight reflected_light(const Scene& scene, const RayCaster& ray_caster,
                               const SurfacePoint& point, const SurfaceSampling& sampling);

}  // namespace brume
