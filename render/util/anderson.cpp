#include "render/util/anderson.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace brume {
namespace {

// Elements whose products are summed in single precision.
constexpr std::size_t block = 64;

// The combination of past changes closest to a residual, by its normal equations.
glm::dvec4 closest(glm::dmat4 products, const glm::dvec4& projections, std::size_t count) {
  static_assert(AndersonAcceleration::depth == 4);
  double trace = 0.0;
  for (int i = 0; i < static_cast<int>(count); ++i) trace += products[i][i];
  for (int i = 0; i < 4; ++i) {
    // Changes that are nearly alike would have huge factors; those that are missing have none.
    if (i < static_cast<int>(count)) {
      products[i][i] += 1e-10 * trace + 1e-300;
    } else {
      products[i][i] = 1.0;
    }
  }
  const glm::dvec4 factors = glm::inverse(products) * projections;
  for (int i = 0; i < 4; ++i) {
    if (!std::isfinite(factors[i])) return glm::dvec4(0.0);
  }
  return factors;
}

std::vector<float> difference(std::span<const float> a, std::span<const float> b) {
  std::vector<float> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
  return result;
}

}  // namespace

void AndersonAcceleration::advance(std::span<float> x, std::span<const float> fx) {
  assert(x.size() == fx.size());
  std::vector<float> residual = difference(fx, x);
  if (!last_residual_.empty()) {
    residual_changes_.push_back(difference(residual, last_residual_));
    fx_changes_.push_back(difference(fx, last_fx_));
    if (residual_changes_.size() > depth) {
      residual_changes_.pop_front();
      fx_changes_.pop_front();
    }
  }
  const std::size_t count = residual_changes_.size();
  glm::dmat4 products(0.0);
  glm::dvec4 projections(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = static_cast<int>(i);
    projections[column] = dot(residual_changes_[i], residual);
    for (std::size_t j = 0; j <= i; ++j) {
      const auto row = static_cast<int>(j);
      products[column][row] = products[row][column] =
          dot(residual_changes_[i], residual_changes_[j]);
    }
  }
  const glm::dvec4 factors = closest(products, projections, count);
  std::copy(fx.begin(), fx.end(), x.begin());
  for (std::size_t i = 0; i < count; ++i) {
    const auto factor = static_cast<float>(factors[static_cast<int>(i)]);
    const float* change = fx_changes_[i].data();
    for (std::size_t k = 0; k < x.size(); ++k) x[k] -= factor * change[k];
  }
  last_residual_ = std::move(residual);
  last_fx_.assign(fx.begin(), fx.end());
}

double AndersonAcceleration::dot(std::span<const float> a, std::span<const float> b) const {
  const std::size_t rows = a.size() / weights_.size();
  std::vector<double> sums(rows, 0.0);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    const std::size_t first = row * weights_.size();
    for (std::size_t begin = 0; begin < weights_.size(); begin += block) {
      const std::size_t end = std::min(begin + block, weights_.size());
      float sum = 0.0f;
      for (std::size_t i = begin; i < end; ++i) sum += weights_[i] * a[first + i] * b[first + i];
      sums[row] += static_cast<double>(sum);
    }
  });
  double total = 0.0;
  for (const double sum : sums) total += sum;
  return total;
}

}  // namespace brume
