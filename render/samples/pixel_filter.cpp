#include "render/samples/pixel_filter.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace brume {
namespace {

// The four-term window of Harris ("On the use of windows for harmonic analysis with the discrete
// Fourier transform", 1978), of which the first is the mean.
constexpr double a0 = 0.35875, a1 = 0.48829, a2 = 0.14128, a3 = 0.01168;
constexpr double turn = 2.0 * std::numbers::pi;

// Integral of the window over [0, u] of its width, from 0 to 1.
double cumulative(double u) {
  return u + (-a1 / turn * std::sin(turn * u) + a2 / (2.0 * turn) * std::sin(2.0 * turn * u) -
              a3 / (3.0 * turn) * std::sin(3.0 * turn * u)) /
                 a0;
}

// The digits of k in base 2 mirrored at the point: van der Corput's sequence, in [0, 1).
double radical_inverse(int k) {
  double inverse = 0.0;
  for (double digit = 0.5; k > 0; k /= 2, digit *= 0.5) inverse += k % 2 * digit;
  return inverse;
}

// The same of k < count, moved to the middles of the intervals that `count` of them divide [0, 1)
// into, so that their mean is 1/2 where count is a power of 2.
double stratified_inverse(int k, int count) {
  const double shifted = radical_inverse(k) + 0.5 / count;
  return shifted - std::floor(shifted);
}

}  // namespace

double pixel_filter::density(double distance) {
  const double u = distance / width + 0.5;
  if (!(u > 0.0 && u < 1.0)) return 0.0;
  return (a0 - a1 * std::cos(turn * u) + a2 * std::cos(2.0 * turn * u) -
          a3 * std::cos(3.0 * turn * u)) /
         (a0 * width);
}

double pixel_filter::sample(double u) {
  // Bisection: the window is 0 at its ends, where Newton's method fails.
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (cumulative(middle) < u ? low : high) = middle;
  }
  return (0.5 * (low + high) - 0.5) * width;
}

std::vector<glm::dvec2> pixel_samples(int count) {
  assert(count >= 1);
  if (count == 1) return {glm::dvec2(0.0)};
  std::vector<glm::dvec2> samples;
  for (int k = 0; k < count; ++k) {
    samples.emplace_back(pixel_filter::sample((k + 0.5) / count),
                         pixel_filter::sample(stratified_inverse(k, count)));
  }
  return samples;
}

}  // namespace brume
