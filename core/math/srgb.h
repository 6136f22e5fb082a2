#pragma once

#include <cmath>

namespace brume {

// sRGB (IEC 61966-2-1): slope * x up to `knee`, gain * x^(1 / exponent) - offset beyond.
namespace srgb {
constexpr double knee = 0.0031308;
constexpr double slope = 12.92;
constexpr double gain = 1.055;
constexpr double offset = 0.055;
constexpr double exponent = 2.4;
}  // namespace srgb

// The encoding of linear light in [0, 1].
template <class Real>
Real srgb_encoded(Real x) {
  if (x <= Real(srgb::knee)) return Real(srgb::slope) * x;
  return Real(srgb::gain) * std::pow(x, Real(1) / Real(srgb::exponent)) - Real(srgb::offset);
}

// Linear light of its encoding in [0, 1].
template <class Real>
Real srgb_decoded(Real x) {
  if (x <= Real(srgb::slope * srgb::knee)) return x / Real(srgb::slope);
  return std::pow((x + Real(srgb::offset)) / Real(srgb::gain), Real(srgb::exponent));
}

}  // namespace brume
