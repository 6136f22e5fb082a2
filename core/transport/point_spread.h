#pragma once

#include <vector>

#include "core/math/spherical_harmonics.h"

namespace brume {

// Point spread functions of a homogeneous medium (section 4 of the paper, after Sun et al. 2005):
// what single scattering makes of a light at optical depth T from a receiver.

// The radiance scattered once towards the receiver from an angle gamma off the light, per unit of
// the irradiance I0 / D^2 that would arrive without the medium, is T e^-T point_spread(T, gamma)
// [1/sr]. At T = 1 this is the paper's NPSF, which the paper takes for every T.
//
//   point_spread = 1 / (4 pi sin gamma) *
//     integral over phi in [0, pi - gamma] of exp(-T (t + r - 1)) dphi,
//
// where t and r are the distances, in units of D, from receiver and light to the point of the view
// ray that the light sees at an angle phi from the receiver. T >= 0; gamma in (0, pi] [radians],
// infinite like 1 / (4 gamma) towards 0. Relative error at most 1e-11.
double point_spread(double T, double gamma);

// The m = 0 coefficients of point_spread(T, .) around +z, T in [0, 100]; relative error at most
// 2e-9. A quadrature of 12,288 points: for each pixel there is SpreadTable.
ZonalSh<double> point_spread_sh(double T);

// The paper's published NPSF coefficients: point_spread_sh(1) within 3e-5.
inline constexpr ZonalSh<double> paper_point_spread_sh = {0.332818, 0.332488, 0.302428,
                                                          0.275773, 0.254051, 0.236333};

// The point spread function of distant light, such as an environment; the paper uses its NPSF
// there, which includes the halo of a near light and is up to 2.5 times too bright. The receiver is
// at the center of a ball of medium of radius 1 and optical depth T, light comes from one
// direction:
//   distant_spread(T, gamma) = 1 / (4 pi) * integral over t in [0, 1] of exp(-T (t + r - 1)),
// where r is the path of the light in the ball to the point at t of the view ray, gamma off the
// light. T >= 0. 1 / (4 pi) at T = 0.
//
// Its m = 0 coefficients, T in [0, 100]; error at most 2e-9 of the first.
ZonalSh<double> distant_spread_sh(double T);

// Interpolated coefficients of one of the two for all T.
class SpreadTable {
 public:
  // The tables of point_spread_sh() and distant_spread_sh(), built on the first call. Thread-safe.
  static const SpreadTable& point();
  static const SpreadTable& distant();

  // T >= 0; error at most 2e-6 of each coefficient (point), 4e-6 of the first (distant). Above T =
  // 100, where T e^-T is 4e-42, as at 100.
  [[nodiscard]] ZonalSh<double> operator()(double T) const;

 private:
  explicit SpreadTable(ZonalSh<double> (*exact)(double));

  std::vector<ZonalSh<double>> nodes_;
};

}  // namespace brume
