#pragma once

#include <cmath>

namespace brume {

// The sRGB encoding of linear light in [0, 1] (IEC 61966-2-1).
template <class Real>
Real srgb_encoded(Real x) {
  return x <= Real(0.0031308) ? Real(12.92) * x
                              : Real(1.055) * std::pow(x, Real(1) / Real(2.4)) - Real(0.055);
}

}  // namespace brume
