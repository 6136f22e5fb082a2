#pragma once

#include "tests/core/math/sh_convolve.h"

namespace brume {

// The light that arrives at a surface point through the medium, attenuated and scattered once, as
// spherical harmonics of the direction it comes from.

// From a point light (eq. 25), per unit of its radiant intensity over the squared distance
// I0 / d^2: e^-T (T delta * spread + delta), delta in the unit direction p -> s, T the optical
// depth between them; spread as of SpreadTable::point() or paper_point_spread_sh.
template <class Real>
ShVector<Real> incident_point_light(int order, const glm::vec<3, Real, glm::defaultp>& to_light,
                                    Real T, const ZonalSh<Real>& spread) {
  const ShVector<Real> delta = sh_basis(order, to_light);
  const ShVector<Real> scattered = sh_convolve(delta, spread);
  const Real attenuation = std::exp(-T);
  ShVector<Real> light(order);
  for (std::size_t i = 0; i < light.size(); ++i) {
    light[i] = attenuation * (T * scattered[i] + delta[i]);
  }
  return light;
}

// From an environment of radiance L (eq. 27): e^-Tbar (Tbar L * spread + L), Tbar as of
// average_depth(); spread as of SpreadTable::distant(), or as the paper has it, which is too
// bright.
template <class Value, class Real>
ShVector<Value> incident_environment(const ShVector<Value>& L, Real Tbar,
                                     const ZonalSh<Real>& spread) {
  const ShVector<Value> scattered = sh_convolve(L, spread);
  const Real attenuation = std::exp(-Tbar);
  ShVector<Value> light(L.order());
  for (std::size_t i = 0; i < light.size(); ++i) {
    light[i] = attenuation * (Tbar * scattered[i] + L[i]);
  }
  return light;
}

}  // namespace brume
