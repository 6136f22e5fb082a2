#include "render/simd/scatter_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/simd/coefficients.h"

namespace brume {
namespace {

constexpr std::size_t terms = ScatterTable::degree + 1;

// Values at the Chebyshev nodes cos(pi (k + 1/2) / terms) to the powers of x, highest first.
std::array<float, terms> powers(const std::array<double, terms>& values) {
  std::array<double, terms> sum{};
  // The Chebyshev polynomials, lowest power first: T_j+1 = 2 x T_j - T_j-1.
  std::array<double, terms> before{};
  std::array<double, terms> now{1.0};
  for (std::size_t j = 0; j < terms; ++j) {
    double coefficient = 0.0;
    for (std::size_t k = 0; k < terms; ++k) {
      coefficient += values[k] * std::cos(std::numbers::pi * static_cast<double>(j) *
                                          (static_cast<double>(k) + 0.5) / terms);
    }
    coefficient *= (j == 0 ? 1.0 : 2.0) / terms;
    std::array<double, terms> next{};
    for (std::size_t i = 0; i < terms; ++i) {
      sum[i] += coefficient * now[i];
      next[i] = (i > 0 ? (j == 0 ? 1.0 : 2.0) * now[i - 1] : 0.0) - before[i];
    }
    before = now;
    now = next;
  }
  std::array<float, terms> result;
  std::transform(sum.rbegin(), sum.rend(), result.begin(),
                 [](double x) { return static_cast<float>(x); });
  return result;
}

}  // namespace

template <class Spread>
ScatterTable::ScatterTable(const Spread& spread) {
  std::array<std::array<double, terms>, sh_max_bands> values;
  for (std::size_t k = 0; k < terms; ++k) {
    const double x = std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / terms);
    const double y = (x + 1.0) / coefficient::scatter_scale;
    const double root = y / (1.0 - y);
    const ZonalSh<double> zonal = spread(root * root);
    for (std::size_t l = 0; l < values.size(); ++l) {
      values[l][k] =
          std::sqrt(4.0 * std::numbers::pi / (2.0 * static_cast<double>(l) + 1.0)) * zonal[l];
    }
  }
  std::transform(values.begin(), values.end(), polynomials_.begin(), powers);
}

const ScatterTable& ScatterTable::point() {
  static const ScatterTable table(SpreadTable::point());
  return table;
}

const ScatterTable& ScatterTable::distant() {
  static const ScatterTable table(SpreadTable::distant());
  return table;
}

const ScatterTable& ScatterTable::paper() {
  static const ScatterTable table([](double) { return paper_point_spread_sh; });
  return table;
}

ScatterTable::Bands ScatterTable::operator()(float T) const {
  Bands result{};
  if (!(T > 0.0f && T < opaque)) return result;
  const float root = std::sqrt(T);
  const float x = static_cast<float>(coefficient::scatter_scale) * root / (root + 1.0f) - 1.0f;
  const float once = T * std::exp(-T);
  for (std::size_t l = 0; l < result.size(); ++l) {
    float p = polynomials_[l][0];
    for (std::size_t i = 1; i < terms; ++i) p = p * x + polynomials_[l][i];
    result[l] = once * p;
  }
  return result;
}

}  // namespace brume
