#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace brume {

// An integral with an estimate of its absolute error.
template <class Real>
struct Integral {
  Real value = 0;
  Real error = 0;
};

// The 7-point Gauss rule inside the 15-point Kronrod rule on [a, b]. `error` is QUADPACK's
// estimate: the difference of the two rules, which overestimates the Kronrod rule's own error by
// far for smooth f, raised to 3/2 relative to how much f varies.
template <class Real, class Function>
Integral<Real> gauss_kronrod_15(const Function& f, Real a, Real b) {
  // QUADPACK's qk15: positive nodes from the outside in, their Kronrod weights; the Gauss weights
  // belong to the odd positions and the centre.
  constexpr std::array<double, 7> node = {
      0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
      0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
      0.586087235467691130294144691825873, 0.405845151377397166906606412076961,
      0.207784955007898467600689403773245};
  constexpr std::array<double, 7> kronrod = {
      0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
      0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
      0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
      0.204432940075298892414161999234649};
  constexpr std::array<double, 3> gauss = {0.129484966168869693270611432679082,
                                           0.279705391489276667901467771423780,
                                           0.381830050505118944950369775488975};
  const Real center = Real(0.5) * (a + b);
  const Real half = Real(0.5) * (b - a);
  const Real f0 = f(center);
  Real k = Real(0.209482141084727828012999174891714) * f0;
  Real g = Real(0.417959183673469387755102040816327) * f0;
  std::array<Real, 14> values;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const Real step = half * Real(node[i]);
    values[2 * i] = f(center - step);
    values[2 * i + 1] = f(center + step);
    const Real pair = values[2 * i] + values[2 * i + 1];
    k += Real(kronrod[i]) * pair;
    if (i % 2 == 1) g += Real(gauss[i / 2]) * pair;
  }
  const Real mean = Real(0.5) * k;
  Real variation = Real(0.209482141084727828012999174891714) * std::abs(f0 - mean);
  for (std::size_t i = 0; i < values.size(); ++i) {
    variation += Real(kronrod[i / 2]) * std::abs(values[i] - mean);
  }
  const Real difference = std::abs(k - g);
  const Real ratio = variation > 0 ? 200 * difference / variation : Real(0);
  return {half * k, std::abs(half) * variation * std::min(Real(1), ratio * std::sqrt(ratio))};
}

// The integral of f over the intervals between ascending `breakpoints` (at least two), refined
// where the error is largest until the sum of the errors is at most
// max(absolute, relative * |value|), or `max_intervals` intervals were used.
template <class Real, class Function>
Integral<Real> integrate(const Function& f, std::span<const Real> breakpoints, Real relative,
                         Real absolute = 0, std::size_t max_intervals = 4096) {
  struct Piece {
    Real a, b;
    Integral<Real> integral;
  };
  const auto smaller_error = [](const Piece& x, const Piece& y) {
    return x.integral.error < y.integral.error;
  };
  std::vector<Piece> pieces;
  Integral<Real> sum;
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const Real a = breakpoints[i];
    const Real b = breakpoints[i + 1];
    if (!(a < b)) continue;
    pieces.push_back({a, b, gauss_kronrod_15<Real>(f, a, b)});
    sum.value += pieces.back().integral.value;
    sum.error += pieces.back().integral.error;
  }
  std::make_heap(pieces.begin(), pieces.end(), smaller_error);
  max_intervals = std::max(max_intervals, 2 * pieces.size());
  while (!pieces.empty() && sum.error > std::max(absolute, relative * std::abs(sum.value)) &&
         pieces.size() < max_intervals) {
    std::pop_heap(pieces.begin(), pieces.end(), smaller_error);
    const Piece worst = pieces.back();
    pieces.pop_back();
    const Real center = Real(0.5) * (worst.a + worst.b);
    if (!(worst.a < center && center < worst.b)) break;  // no numbers left between a and b
    for (const auto& [a, b] : {std::pair{worst.a, center}, std::pair{center, worst.b}}) {
      pieces.push_back({a, b, gauss_kronrod_15<Real>(f, a, b)});
      std::push_heap(pieces.begin(), pieces.end(), smaller_error);
    }
    // Summed afresh: differences of running sums would leave rounding errors behind.
    sum = {};
    for (const Piece& piece : pieces) {
      sum.value += piece.integral.value;
      sum.error += piece.integral.error;
    }
  }
  return sum;
}

}  // namespace brume
