#pragma once

#include <cmath>
#include <numbers>

#include "core/math/spherical_harmonics.h"

namespace brume {

// The spherical convolution f * g with a zonal kernel: coefficient l, m is
// sqrt(4 pi / (2 l + 1)) g_l f_lm.
template <class Value, class Real>
ShVector<Value> sh_convolve(const ShVector<Value>& f, const ZonalSh<Real>& g) {
  ShVector<Value> result(f.order());
  for (int l = 0; l < f.order(); ++l) {
    const Real factor =
        std::sqrt(4 * std::numbers::pi_v<Real> / Real(2 * l + 1)) * g[static_cast<std::size_t>(l)];
    for (int m = -l; m <= l; ++m) result[sh_index(l, m)] = factor * f[sh_index(l, m)];
  }
  return result;
}

}  // namespace brume
