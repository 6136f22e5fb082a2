#include "core/math/special_functions.h"

#include <cmath>
#include <numbers>

namespace brume {

template <class Real>
Real erfcx(Real x) {
  // Up to 4 the product is safe: exp(16) rounds by 16 epsilon and erfc is far from underflow.
  if (x < Real(4)) return std::exp(x * x) * std::erfc(x);
  // Laplace's continued fraction sqrt(pi) erfcx(x) = 1/(x + (1/2)/(x + (2/2)/(x + ...))).
  Real tail = x;
  for (int k = 30; k >= 1; --k) tail = x + Real(0.5) * Real(k) / tail;
  return std::numbers::inv_sqrtpi_v<Real> / tail;
}

template double erfcx(double);
template float erfcx(float);

}  // namespace brume
