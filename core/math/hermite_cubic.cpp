#include "core/math/hermite_cubic.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace brume {
namespace {

// The real roots of a x^2 + b x + c without cancellation; not finite where there are none.
std::array<double, 2> quadratic_roots(double a, double b, double c) {
  const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4.0 * a * c), b));
  return {q / a, c / q};
}

// Where a cubic passes `level`, between a place above or at it and one below.
double crossing(const HermiteCubic& cubic, double level, double above, double below) {
  constexpr int bits = 60;
  for (int k = 0; k < bits; ++k) {
    const double middle = 0.5 * (above + below);
    (cubic.value(middle) >= level ? above : below) = middle;
  }
  return above;
}

// The same as integral_above(), where the value rises or falls from `low` to `high`.
double monotone_integral_above(const HermiteCubic& cubic, double floor, double low, double high) {
  const bool low_is_above = cubic.value(low) >= floor;
  const bool high_is_above = cubic.value(high) >= floor;
  if (low_is_above && high_is_above) return cubic.integral(low, high);
  if (low_is_above) {
    const double x = crossing(cubic, floor, low, high);
    return cubic.integral(low, x) + floor * (high - x);
  }
  if (high_is_above) {
    const double x = crossing(cubic, floor, high, low);
    return floor * (x - low) + cubic.integral(x, high);
  }
  return floor * (high - low);
}

}  // namespace

double HermiteCubic::value(double x) const {
  const double u = x / length;
  const double v = 1.0 - u;
  return begin + (end - begin) * u * u * (3.0 - 2.0 * u) +
         length * u * v * (begin_slope * v - end_slope * u);
}

// Simpson's rule, exact for cubics.
double HermiteCubic::integral(double low, double high) const {
  return (high - low) / 6.0 * (value(low) + 4.0 * value(0.5 * (low + high)) + value(high));
}

double HermiteCubic::integral_above(double floor, double low, double high) const {
  if (lower_bound() >= floor) return integral(low, high);
  const double chord = (end - begin) / length;
  const auto extrema =
      quadratic_roots(3.0 * (begin_slope + end_slope - 2.0 * chord),
                      2.0 * (3.0 * chord - 2.0 * begin_slope - end_slope), begin_slope);
  std::array<double, 4> ends{low, low, high, high};
  for (std::size_t k = 0; k < 2; ++k) {
    const double x = extrema[k] * length;
    if (x > low && x < high) ends[k + 1] = x;
  }
  std::ranges::sort(ends);
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += monotone_integral_above(*this, floor, ends[k], ends[k + 1]);
  }
  return sum;
}

double HermiteCubic::lower_bound() const {
  return std::min({begin, end, begin + begin_slope * length / 3.0, end - end_slope * length / 3.0});
}

double HermiteCubic::upper_bound() const {
  return std::max({begin, end, begin + begin_slope * length / 3.0, end - end_slope * length / 3.0});
}

}  // namespace brume
