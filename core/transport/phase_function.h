#pragma once

#include <algorithm>
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

// The cosine below which a share of that lies, in [0, 1] (pbrt, "Sampling Phase Functions").
inline double henyey_greenstein_quantile(double share, double g) {
  if (std::abs(g) < 1e-4) return 2.0 * share - 1.0;  // where the inversion loses its digits
  const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * share);
  return std::clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
}

}  // namespace brume
