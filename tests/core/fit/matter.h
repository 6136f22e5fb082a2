#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "brume/gaussian.h"

namespace brume {

// Albedo and emission of the matter at a point.
struct Matter {
  glm::dvec3 albedo;
  glm::dvec3 emission;
};
inline Matter matter_at(std::span<const Gaussian> gaussians, const glm::dvec3& x) {
  double scattering = 0.0;
  glm::dvec3 extinction(0.0);
  glm::dvec3 emitted(0.0);
  for (const Gaussian& g : gaussians) {
    const glm::dvec3 d = warp(g.shape) * (x - g.center) / g.radius;
    const double b = g.density * std::exp(-glm::dot(d, d));
    scattering += b;
    extinction += b / *g.optics.albedo;
    emitted += b / *g.optics.albedo * g.optics.emission;
  }
  return {scattering / extinction, emitted / extinction};
}

}  // namespace brume
