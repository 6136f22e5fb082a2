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

double entire_exponential_integral(double x) {
  constexpr double far = 18.0;  // beyond it the rest, E1(x), is below 1e-9
  if (x > far) return std::log(x) + std::numbers::egamma;
  double sum = 0.0;
  double power = 1.0;  // (-x)^k / k!
  for (int k = 1; k < 80; ++k) {
    power *= -x / k;
    sum -= power / k;
    if (std::abs(power) < 1e-17 * sum) break;
  }
  return sum;
}

double dawson(double x) {
  if (x < 0.2) {
    const double x2 = x * x;
    return x * (1.0 - 2.0 / 3.0 * x2 * (1.0 - 0.4 * x2 * (1.0 - 2.0 / 7.0 * x2)));
  }
  // Odd multiples of the step within 4.4 of x: the others are below 1e-8.
  constexpr double step = 0.4;
  const double even = 2.0 * std::round(x / (2.0 * step));
  double sum = 0.0;
  for (int k = -11; k <= 11; k += 2) {
    const double q = x - (even + k) * step;
    sum += std::exp(-q * q) / (even + k);
  }
  return std::numbers::inv_sqrtpi * sum;
}

}  // namespace brume
