#pragma once

#include <array>

#include "core/math/spherical_harmonics.h"
#include "core/transport/point_spread.h"

namespace brume {

// Single scattering onto surfaces: the factor T PSF_T of eq. 21 per spherical-harmonics band. Light
// with coefficients L_lm outside the medium arrives as (e^-T + factor_l(T)) L_lm (eqs. 25 and 27).
// Stored as polynomials, so SIMD code needs no look-ups.
class ScatterTable {
 public:
  using Bands = std::array<float, sh_max_bands>;

  // factor_l(T) = T e^-T P_l(x), highest power first, x = scatter_scale s / (s + 1) - 1 in [-1, 1],
  // s = sqrt(min(T, opaque)); 0 from `opaque` on.
  static constexpr int degree = 12;
  static constexpr float opaque = 25.0f;
  using Polynomials = std::array<std::array<float, degree + 1>, sh_max_bands>;

  // For point lights, for environments, and the paper's single function for both. Built on the
  // first call. Thread-safe.
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
