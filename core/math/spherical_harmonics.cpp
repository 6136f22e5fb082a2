#include "core/math/spherical_harmonics.h"

#include <algorithm>
#include <vector>

#include "core/math/sphere_rule.h"

namespace brume {
namespace {

constexpr auto bands = static_cast<std::size_t>(sh_max_bands);

}  // namespace

ShRecurrence::ShRecurrence() {
  for (std::size_t m = 1; m < bands; ++m) {
    const auto mm = static_cast<double>(m);
    start[m] = std::sqrt((m == 1 ? 2.0 : 1.0) * (2.0 * mm + 1.0) / (2.0 * mm));
  }
  for (std::size_t l = 1; l < bands; ++l) {
    for (std::size_t m = 0; m < l; ++m) {
      const auto l2 = static_cast<double>(l * l);
      const auto k2 = static_cast<double>((l - 1) * (l - 1));
      const auto m2 = static_cast<double>(m * m);
      up[l][m] = std::sqrt((4.0 * l2 - 1.0) / (l2 - m2));
      down[l][m] = std::sqrt((k2 - m2) / (4.0 * k2 - 1.0));
    }
  }
}

template <class Real>
ShVector<Real> sh_basis(int order, const glm::vec<3, Real, glm::defaultp>& d) {
  static const ShRecurrence recurrence;
  ShVector<Real> y(order);
  Real c = 1;  // sin^m(theta) cos(m phi) and sin^m(theta) sin(m phi)
  Real s = 0;
  Real first = Real(0.5) * std::numbers::inv_sqrtpi_v<Real>;  // q_mm
  for (int m = 0; m < order; ++m) {
    const auto column = static_cast<std::size_t>(m);
    if (m > 0) {
      first *= static_cast<Real>(recurrence.start[column]);
      const Real turned = c * d.x - s * d.y;
      s = s * d.x + c * d.y;
      c = turned;
    }
    Real q = first;
    Real below = 0;
    for (int l = m; l < order; ++l) {
      const auto row = static_cast<std::size_t>(l);
      if (l > m) {
        const Real next = static_cast<Real>(recurrence.up[row][column]) *
                          (d.z * q - static_cast<Real>(recurrence.down[row][column]) * below);
        below = q;
        q = next;
      }
      y[sh_index(l, m)] = q * c;
      if (m > 0) y[sh_index(l, -m)] = q * s;
    }
  }
  return y;
}

template <class Value>
Value sh_evaluate(const ShVector<Value>& f, const glm::dvec3& direction) {
  const ShVector<double> y = sh_basis(f.order(), direction);
  Value sum(0);
  for (std::size_t i = 0; i < f.size(); ++i) sum += f[i] * y[i];
  return sum;
}

namespace {

// Integrals of products of harmonics that vanish come to less; the others are above 5e-3.
constexpr double rounding = 1e-13;

// By a quadrature that is exact for it.
std::vector<ShElement> quarter_turn() {
  constexpr std::size_t size = sh_size(sh_max_bands);
  std::array<double, size * size> matrix{};
  for (const auto& [d, weight] : sphere_rule(2 * (sh_max_bands - 1))) {
    const ShVector<double> rotated_basis = sh_basis(sh_max_bands, d);
    const ShVector<double> basis = sh_basis(sh_max_bands, glm::dvec3(d.x, d.z, -d.y));
    for (std::size_t k = 0; k < matrix.size(); ++k) {
      matrix[k] += weight * rotated_basis[k / size] * basis[k % size];
    }
  }
  std::vector<ShElement> elements;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    if (std::abs(matrix[k]) > rounding) elements.push_back({k / size, k % size, matrix[k]});
  }
  return elements;
}

template <class Value>
ShVector<Value> turn_about_x(const ShVector<Value>& f, bool forward) {
  ShVector<Value> result(f.order());
  for (const ShElement& e : sh_quarter_turn()) {
    if (e.to >= f.size()) break;
    if (forward) {
      result[e.to] += e.value * f[e.from];
    } else {
      result[e.from] += e.value * f[e.to];
    }
  }
  return result;
}

template <class Value>
ShVector<Value> turn_about_z(const ShVector<Value>& f, double angle) {
  ShVector<Value> result = f;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  double c = 1.0;  // of m times the angle
  double s = 0.0;
  for (int m = 1; m < f.order(); ++m) {
    const double turned = c * cosine - s * sine;
    s = s * cosine + c * sine;
    c = turned;
    for (int l = m; l < f.order(); ++l) {
      const Value& a = f[sh_index(l, m)];
      const Value& b = f[sh_index(l, -m)];
      result[sh_index(l, m)] = c * a - s * b;
      result[sh_index(l, -m)] = s * a + c * b;
    }
  }
  return result;
}

}  // namespace

std::span<const ShElement> sh_quarter_turn() {
  static const std::vector<ShElement> elements = quarter_turn();
  return elements;
}

template <class Value>
ShVector<Value> sh_rotate(const ShVector<Value>& f, const glm::dquat& q) {
  // q as turns about z, y and z by gamma, beta and alpha; that about y as one about z between
  // quarter turns about x.
  const double beta = 2.0 * std::atan2(std::hypot(q.x, q.y), std::hypot(q.w, q.z));
  const double sum = std::atan2(q.z, q.w);
  const double difference = std::atan2(-q.x, q.y);
  ShVector<Value> result = turn_about_x(turn_about_z(f, sum - difference), true);
  result = turn_about_x(turn_about_z(result, beta), false);
  return turn_about_z(result, sum + difference);
}

namespace {

// By a quadrature that is exact for products of three harmonics.
std::vector<ShTriple> all_triples() {
  constexpr std::size_t size = sh_size(sh_max_bands);
  std::vector<ShVector<double>> y;
  const std::vector<SphereNode> rule = sphere_rule(3 * (sh_max_bands - 1));
  y.reserve(rule.size());
  for (const SphereNode& node : rule) y.push_back(sh_basis(sh_max_bands, node.direction));
  std::vector<ShTriple> triples;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) {
        double sum = 0.0;
        for (std::size_t n = 0; n < rule.size(); ++n) {
          sum += rule[n].weight * y[n][i] * y[n][j] * y[n][k];
        }
        if (std::abs(sum) < rounding) continue;
        triples.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
                           static_cast<std::uint8_t>(k), sum});
      }
    }
  }
  return triples;
}

using TriplesByOrder = std::array<std::vector<ShTriple>, bands + 1>;

TriplesByOrder triples_by_order() {
  TriplesByOrder lists;
  for (const ShTriple& triple : all_triples()) {
    const auto max_index = static_cast<std::size_t>(std::max({triple.i, triple.j, triple.k}));
    for (std::size_t order = 1; order <= bands; ++order) {
      if (max_index < order * order) lists[order].push_back(triple);
    }
  }
  return lists;
}

}  // namespace

std::span<const ShTriple> sh_triples(int order) {
  assert(1 <= order && order <= sh_max_bands);
  static const TriplesByOrder lists = triples_by_order();
  return lists[static_cast<std::size_t>(order)];
}

template <class Value>
ShVector<Value> sh_product(const ShVector<Value>& f, const ShVector<double>& g) {
  assert(f.order() == g.order());
  ShVector<Value> result(f.order());
  if (f.order() == 0) return result;
  for (const ShTriple& triple : sh_triples(f.order())) {
    result[triple.k] += triple.value * g[triple.j] * f[triple.i];
  }
  return result;
}

template ShVector<double> sh_basis(int, const glm::dvec3&);
template ShVector<float> sh_basis(int, const glm::vec3&);
#define BRUME_SPHERICAL_HARMONICS(Value)                                         \
  template Value sh_evaluate(const ShVector<Value>&, const glm::dvec3&);         \
  template ShVector<Value> sh_rotate(const ShVector<Value>&, const glm::dquat&); \
  template ShVector<Value> sh_product(const ShVector<Value>&, const ShVector<double>&);
BRUME_SPHERICAL_HARMONICS(double)
BRUME_SPHERICAL_HARMONICS(glm::dvec3)
#undef BRUME_SPHERICAL_HARMONICS

}  // namespace brume
