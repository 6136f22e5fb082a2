#include "tools/bench/errors/unbiased_error.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace brume {
namespace {

constexpr std::size_t none = independent_runs;

// Sum of squares of the mean, from products of two different runs, without run `left_out`
// (jackknife).
double square(const Runs& runs, std::size_t left_out) {
  double sum = 0.0;
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    glm::dvec3 total(0.0);
    double diagonal = 0.0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (k == left_out) continue;
      total += runs[k][i];
      diagonal += glm::dot(runs[k][i], runs[k][i]);
    }
    sum += glm::dot(total, total) - diagonal;
  }
  const double n = left_out == none ? independent_runs : independent_runs - 1;
  return sum / (n * (n - 1.0));
}

}  // namespace

ErrorEstimate unbiased_error(const Runs& differences, const Runs& values) {
  const auto ratio = [&](std::size_t left_out) {
    return square(differences, left_out) / square(values, left_out);
  };
  constexpr double n = independent_runs;
  std::array<double, independent_runs> without{};
  double mean = 0.0;
  for (std::size_t k = 0; k < independent_runs; ++k) {
    without[k] = ratio(k);
    mean += without[k] / n;
  }
  double variance = 0.0;
  for (const double x : without) variance += (n - 1.0) / n * (x - mean) * (x - mean);
  constexpr double student = 2.365;  // 97.5% of seven degrees of freedom
  const double wide = student * std::sqrt(variance);
  const double total = ratio(none);
  const auto root = [](double x) { return std::sqrt(std::max(0.0, x)); };
  return {root(total), root(total - wide), root(total + wide), differences[0].size()};
}

}  // namespace brume
