#pragma once

#include "brume/medium.h"
#include "core/transport/optical_depth.h"

namespace brume {

// The optical depth from a point to infinity, averaged over all directions (section 4.2 of the
// paper, eq. 26): what stands for T between a surface and an environment.

// For the Gaussian with a = c = 1 at distance u >= 0 from its centre, the paper's table:
//   Tbar(u) = 1 / (4 pi) * integral over w of integral over t >= 0 of exp(-|u + t w|^2)
//           = sqrt(pi) / 2 * D(u) / u, D being Dawson's integral;
// sqrt(pi) / 2 at 0, about sqrt(pi) / (4 u^2) far out. Relative error at most 2e-15 (double),
// 5e-7 (float).
template <class Real>
Real unit_average_depth(Real u);

// Tbar_i(p) = c / a * Tbar(a |p - b|). Of an ellipsoid of radii r_k, in its own axes from the
// middle to p = q, from 1 / |x - p|^2 as the integral of exp(-s |x - p|^2) over s >= 0:
//   c sqrt(pi) / 4 * integral of prod (l_k + s)^(-1/2) exp(-sum s l_k q_k^2 / (l_k + s)) ds,
// l_k = 1 / r_k^2. Relative error at most 1e-12 (double), 1e-5 (float).
template <class Real>
Real average_depth(const GaussianTerm<Real>& g, const Vec3<Real>& p);

// Tbar(p) = b0 far + sum of Tbar_i(p). The homogeneous part of an endless medium would hide any
// environment: it counts up to `far` [u], the same for all points, as in the paper.
double average_depth(const Medium& medium, double far, const glm::dvec3& p);

#define BRUME_AVERAGE_DEPTH(Real)                \
  extern template Real unit_average_depth(Real); \
  extern template Real average_depth(const GaussianTerm<Real>&, const Vec3<Real>&);
BRUME_AVERAGE_DEPTH(double)
BRUME_AVERAGE_DEPTH(float)
#undef BRUME_AVERAGE_DEPTH

}  // namespace brume
