#pragma once

#include <glm/geometric.hpp>

#include "core/scene/ray_noise.h"
#include "core/transport/optical_depth.h"

namespace brume {

// line_profile() of a view ray displaced by noise: t0 is that of the undisplaced ray, only the
// distance changes. `w` is unit.
template <class Real>
LineProfile<Real> view_line_profile(const GaussianTerm<Real>& g, const Vec3<Real>& eye,
                                    const Vec3<Real>& w, const RayNoise& noise) {
  LineProfile<Real> line = line_profile(g, eye, w);
  if (!noise.on()) return line;
  const glm::dvec3 direction(w);
  const glm::dvec3 x = glm::dvec3(eye) + static_cast<double>(line.t0) * direction;
  const glm::dvec3 offset = -glm::dvec3(g.scaled(Vec3<Real>(x))) - noise.shift(x, direction);
  line.e = static_cast<Real>(glm::dot(offset, offset));
  return line;
}

}  // namespace brume
