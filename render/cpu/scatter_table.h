#pragma once

#include <array>

#include "core/math/spherical_harmonics.h"
#include "core/transport/point_spread.h"

namespace brume {

// How much light the medium adds, scattered once, to light that it also attenuates: the T PSF_T of
// eq. 21 as the factor of each band of spherical harmonics. Light with the coefficients L_lm
// outside the medium arrives as (e^-T + factor_l(T)) L_lm (eqs. 25 and 27). Kept as polynomials, so
// that SIMD code needs no look-ups.
class ScatterTable {
 public:
  using Bands = std::array<float, sh_most_bands>;

  // factor_l(T) = T e^-T P_l(x), highest power first, x = scale s / (s + 1) - 1 in [-1, 1],
  // s = sqrt(min(T, opaque)); 0 from `opaque` on.
  static constexpr int degree = 12;
  static constexpr float opaque = 25.0f;
  static constexpr float scale = 2.4f;
  using Polynomials = std::array<std::array<float, degree + 1>, sh_most_bands>;

  // Of point lights and of environments, by the spread of T, and of both as the paper has them.
  // Made on the first call. Thread-safe.
  static const ScatterTable& point();
  static const ScatterTable& distant();
  static const ScatterTable& paper();

  // T e^-T sqrt(4 pi / (2 l + 1)) spread_l(T) for T >= 0; absolute error at most 2e-5.
  [[nodiscard]] Bands operator()(float T) const;
  [[nodiscard]] const Polynomials& polynomials() const { return polynomials_; }

 private:
  template <class Spread>
  explicit ScatterTable(const Spread& spread);

  Polynomials polynomials_;
};

}  // namespace brume
