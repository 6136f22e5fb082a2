#pragma once

#include <vector>

#include "core/math/spherical_harmonics.h"

namespace brume {

// The point spread function of a homogeneous medium (section 4 of the paper, after Sun et al.
// 2005): what single scattering makes of a point light at optical depth T from a receiver.

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
// 1e-9. A quadrature of 9,216 points: for each pixel there is PointSpreadTable.
ZonalSh<double> point_spread_sh(double T);

// The same of the NPSF as the paper prints them: point_spread_sh(1) within 3e-5.
inline constexpr ZonalSh<double> paper_point_spread_sh = {0.332818, 0.332488, 0.302428,
                                                          0.275773, 0.254051, 0.236333};

// point_spread_sh, interpolated.
class PointSpreadTable {
 public:
  PointSpreadTable();

  // The one table, made on the first call. Thread-safe.
  static const PointSpreadTable& shared();

  // T >= 0; relative error at most 2e-6. Above T = 100, where T e^-T is 4e-42, as at 100.
  [[nodiscard]] ZonalSh<double> operator()(double T) const;

 private:
  std::vector<ZonalSh<double>> nodes_;
};

}  // namespace brume
