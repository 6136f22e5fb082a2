#include "core/fit/ellipsoid_block.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

namespace brume {
namespace {

// exp(-x) for x >= 0, with a relative error of 3e-6: short, so that compilers make vectors of it.
float exp_of_minus(float x) {
  // 2^y = 2^n 2^f, n being y rounded: by adding 1.5 * 2^23.
  constexpr float rounding = 12582912.0f;
  const float y = std::max(-1.44269504f * x, -126.0f);
  const float shifted = y + rounding;
  const float f = 0.693147181f * (y - (shifted - rounding));
  const float power =
      1.0f +
      f * (1.0f + f * (0.5f + f * (0.166666667f + f * (0.0416666667f + f * 0.00833333333f))));
  const std::uint32_t exponent = (std::bit_cast<std::uint32_t>(shifted) + 127u) << 23;
  return power * std::bit_cast<float>(exponent);
}

}  // namespace

EllipsoidBlock::EllipsoidBlock(const FitGaussian& g, const glm::dvec3& first,
                               const glm::dvec3& spacing, double cutoff)
    : first_(g.a * (g.shape * (first - g.b))),
      along_x_(g.a * spacing.x * g.shape[0]),
      along_y_(g.a * spacing.y * g.shape[1]),
      along_z_(g.a * spacing.z * g.shape[2]),
      cutoff_square_(static_cast<float>(cutoff * cutoff)) {}

bool EllipsoidBlock::is_reached() const {
  // By the ball around the block, where the ellipsoid is one.
  constexpr float half = 0.5f * (side - 0.5f);
  const glm::vec3 middle = first_ + half * (along_x_ + along_y_ + along_z_);
  float radius = 0.0f;
  for (const float x : {-half, half}) {
    for (const float y : {-half, half}) {
      radius = std::max(radius, glm::length(x * along_x_ + y * along_y_ + half * along_z_));
    }
  }
  return glm::length(middle) - radius < std::sqrt(cutoff_square_);
}

// Calls visit(t of a row's first point, index of that point).
template <class Visit>
void EllipsoidBlock::each_row(Visit visit) const {
  const float per_square = 1.0f / glm::dot(along_z_, along_z_);
  int index = 0;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j, index += side) {
      const glm::vec3 t =
          first_ + static_cast<float>(i) * along_x_ + static_cast<float>(j) * along_y_;
      // The row's nearest point to the center.
      const float k = std::clamp(-glm::dot(t, along_z_) * per_square, 0.0f, side - 1.0f);
      const glm::vec3 nearest = t + k * along_z_;
      if (glm::dot(nearest, nearest) < cutoff_square_) visit(t, index);
    }
  }
}

EllipsoidBlock::Row EllipsoidBlock::exponentials(const glm::vec3& t) const {
  const float c0 = glm::dot(t, t);
  const float c1 = 2.0f * glm::dot(t, along_z_);
  const float c2 = glm::dot(along_z_, along_z_);
  Row row;
  for (int k = 0; k < side; ++k) {
    const auto z = static_cast<float>(k);
    row[static_cast<std::size_t>(k)] = exp_of_minus(std::max(c0 + z * (c1 + z * c2), 0.0f));
  }
  return row;
}

void EllipsoidBlock::add_gaussian(float c, float* values) const {
  each_row([&](const glm::vec3& t, int index) {
    const Row e = exponentials(t);
    for (std::size_t k = 0; k < side; ++k) values[index + static_cast<int>(k)] += c * e[k];
  });
}

void EllipsoidBlock::add_polynomial(float c, const Polynomial& p, float* values) const {
  const glm::vec3 quadratic_z = p.quadratic * along_z_;
  const float p2 = c * glm::dot(along_z_, quadratic_z);
  const float linear_z = glm::dot(p.linear, along_z_);
  each_row([&](const glm::vec3& t, int index) {
    const Row e = exponentials(t);
    const float p0 = c * (p.constant + glm::dot(p.linear, t) + glm::dot(t, p.quadratic * t));
    const float p1 = c * (linear_z + 2.0f * glm::dot(t, quadratic_z));
    for (int k = 0; k < side; ++k) {
      const auto z = static_cast<float>(k);
      values[index + k] += e[static_cast<std::size_t>(k)] * (p0 + z * (p1 + z * p2));
    }
  });
}

void EllipsoidBlock::add_moments(float factor, const float* weights, Moments& sum) const {
  // By powers of k along each row: t = t_row + k along_z.
  double one = 0.0;
  glm::dvec3 first(0.0);
  glm::dvec3 along(0.0);  // of k t_row
  double k1 = 0.0;
  double k2 = 0.0;
  glm::dmat3 second(0.0);
  each_row([&](const glm::vec3& t_row, int index) {
    const Row e = exponentials(t_row);
    float s0 = 0.0f, s1 = 0.0f, s2 = 0.0f;
    for (int k = 0; k < side; ++k) {
      const auto z = static_cast<float>(k);
      const float w = weights[index + k] * e[static_cast<std::size_t>(k)];
      s0 += w;
      s1 += z * w;
      s2 += z * z * w;
    }
    const glm::dvec3 t(t_row);
    const auto w0 = static_cast<double>(s0);
    const auto w1 = static_cast<double>(s1);
    one += w0;
    k1 += w1;
    k2 += static_cast<double>(s2);
    first += w0 * t;
    along += w1 * t;
    second[0] += w0 * t.x * t;
    second[1] += w0 * t.y * t;
    second[2] += w0 * t.z * t;
  });
  const auto f = static_cast<double>(factor);
  const glm::dvec3 z(along_z_);
  sum.one += f * one;
  sum.first += f * (first + k1 * z);
  sum.second += f * (second + glm::outerProduct(along, z) + glm::outerProduct(z, along) +
                     k2 * glm::outerProduct(z, z));
}

}  // namespace brume
