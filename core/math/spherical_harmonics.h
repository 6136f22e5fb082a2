#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>

namespace brume {

// Real, orthonormal spherical harmonics Y_lm without the Condon-Shortley phase: Y_11 = +0.4886 x,
// Y_1-1 = +0.4886 y, Y_10 = 0.4886 z. A function on the sphere has one coefficient for each l, m at
// index l (l + 1) + m; `order` is the number of bands, l < order, from 1 to 6.

inline constexpr int sh_max_bands = 6;

constexpr std::size_t sh_index(int l, int m) {
  return static_cast<std::size_t>(l * (l + 1) + m);
}
constexpr std::size_t sh_size(int order) {
  return static_cast<std::size_t>(order * order);
}

// Coefficients of a function on the sphere, zero at first. Value is a scalar or a glm vector (RGB).
template <class Value>
class ShVector {
 public:
  explicit ShVector(int order = 0) : order_(order) {
    assert(0 <= order && order <= sh_max_bands);
    values_.fill(Value(0));
  }

  [[nodiscard]] int order() const { return order_; }
  [[nodiscard]] std::size_t size() const { return sh_size(order_); }
  Value& operator[](std::size_t i) { return values_[i]; }
  const Value& operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] std::span<const Value> values() const { return {values_.data(), size()}; }

 private:
  int order_;
  std::array<Value, sh_size(sh_max_bands)> values_;
};

// The m = 0 coefficients, l = 0 to 5, of a function that depends only on the angle to +z.
template <class Real>
using ZonalSh = std::array<Real, sh_max_bands>;

// All Y_lm at a unit direction, which are also the coefficients of a delta function there
// (eq. 24). By the three-term recurrence in z, stable at the poles; absolute error at most 2e-14
// (double), 3e-6 (float).
template <class Real>
ShVector<Real> sh_basis(int order, const glm::vec<3, Real, glm::defaultp>& direction);

// The parts of sh_basis(): the fully normalised associated Legendre functions over sin^m,
// q_lm(z), obey
//   q_00 = 1 / sqrt(4 pi),  q_mm = start[m] q_m-1,m-1,
//   q_lm = up[l][m] (z q_l-1,m - down[l][m] q_l-2,m).
// `start` has the factor sqrt(2) of the real harmonics with m != 0 in it.
struct ShRecurrence {
  using Row = std::array<double, sh_max_bands>;
  Row start{};
  std::array<Row, sh_max_bands> up{};
  std::array<Row, sh_max_bands> down{};

  ShRecurrence();
};

// The value of the function at a unit direction.
template <class Value>
Value sh_evaluate(const ShVector<Value>& f, const glm::dvec3& direction);

// The integral of the product of two functions over the sphere.
template <class Value, class Real>
Value sh_dot(const ShVector<Value>& f, const ShVector<Real>& g) {
  assert(f.order() == g.order());
  Value sum(0);
  for (std::size_t i = 0; i < f.size(); ++i) sum += f[i] * g[i];
  return sum;
}

// The function turned by the unit quaternion q: result(w) = f(q^-1 w). Exact but for rounding.
template <class Value>
ShVector<Value> sh_rotate(const ShVector<Value>& f, const glm::dquat& q);

// The elements (to, from) of the matrix that turns coefficients by +90 degrees about +x, which
// takes +y to +z, but for those that vanish; ascending in `to`. Its inverse is its transpose.
// Thread-safe.
struct ShElement {
  std::size_t to, from;
  double value;
};
std::span<const ShElement> sh_quarter_turn();

// The integral of Y_i Y_j Y_k over the sphere, for one of the triples where it is not zero. All
// permutations are listed.
struct ShTriple {
  std::uint8_t i, j, k;
  double value;
};

// The non-zero triples of an order (83, 353, 1158, 2907 for orders 3 to 6), ascending in i, j, k.
// Made on the first call. Thread-safe.
std::span<const ShTriple> sh_triples(int order);

// The projection of the product f g on the bands of f. Both have the same order.
template <class Value>
ShVector<Value> sh_product(const ShVector<Value>& f, const ShVector<double>& g);

extern template ShVector<double> sh_basis(int, const glm::dvec3&);
extern template ShVector<float> sh_basis(int, const glm::vec3&);
#define BRUME_SPHERICAL_HARMONICS(Value)                                                \
  extern template Value sh_evaluate(const ShVector<Value>&, const glm::dvec3&);         \
  extern template ShVector<Value> sh_rotate(const ShVector<Value>&, const glm::dquat&); \
  extern template ShVector<Value> sh_product(const ShVector<Value>&, const ShVector<double>&);
BRUME_SPHERICAL_HARMONICS(double)
BRUME_SPHERICAL_HARMONICS(glm::dvec3)
#undef BRUME_SPHERICAL_HARMONICS

}  // namespace brume
