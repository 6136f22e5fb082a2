#pragma once

#include <cmath>

namespace brume {

// The Henyey-Greenstein phase function relative to isotropic scattering: 4 pi p. `cos_theta` is the
// cosine of the scattering angle, +1 forward; g is its mean, in [-0.95, 0.95] (beyond, the forward
// lobe is sharper than slices and pixels resolve).
template <class Real>
Real henyey_greenstein(Real cos_theta, Real g) {
  const Real s = 1 + g * g - 2 * g * cos_theta;
  return (1 - g * g) / (s * std::sqrt(s));
}

}  // namespace brume
