#pragma once

#include <cmath>

namespace brume {

// The digits of k in base 2 mirrored at the point: van der Corput's sequence, in [0, 1).
inline double radical_inverse(int k) {
  double inverse = 0.0;
  for (double digit = 0.5; k > 0; k /= 2, digit *= 0.5) inverse += k % 2 * digit;
  return inverse;
}

// The same of k < count, moved to the middles of the intervals that `count` of them divide [0, 1)
// into, so that their mean is 1/2 where count is a power of 2.
inline double stratified_inverse(int k, int count) {
  const double shifted = radical_inverse(k) + 0.5 / count;
  return shifted - std::floor(shifted);
}

}  // namespace brume
