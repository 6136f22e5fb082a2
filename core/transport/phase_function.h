#pragma once

#include <cmath>

namespace brume {

// The Henyey-Greenstein phase function relative to isotropic scattering: 4 pi k. `cos_theta` is
// the cosine of the angle by which light turns, +1 for light that goes straight on; g is the mean
// of it, in [-0.95, 0.95] (beyond, the peak is sharper than slices and pixels resolve).
template <class Real>
Real henyey_greenstein(Real cos_theta, Real g) {
  const Real s = 1 + g * g - 2 * g * cos_theta;
  return (1 - g * g) / (s * std::sqrt(s));
}

}  // namespace brume
