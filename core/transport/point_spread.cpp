#include "core/transport/point_spread.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/quadrature.h"
#include "core/math/sphere_rule.h"

namespace brume {
namespace {

// t + r - 1 at phi = x delta, where delta = pi - gamma and x is in [0, 1): how much longer the path
// by the scattering point is than the straight one. The sines are sums turned into products, so
// nothing cancels.
double detour(double delta, double x) {
  if (!(delta > 0.0)) return 2.0 * x / (1.0 - x);
  return 2.0 * std::cos(0.5 * delta) * std::sin(0.5 * delta * x) /
         std::sin(0.5 * delta * (1.0 - x));
}

}  // namespace

double point_spread(double T, double gamma) {
  const double delta = std::numbers::pi - gamma;
  const auto attenuation = [&](double x) { return std::exp(-T * detour(delta, x)); };
  const std::array<double, 2> all = {0.0, 1.0};
  const double mean = integrate<double>(attenuation, all, 1e-12).value;
  const double spread = delta > 0.0 ? delta / std::sin(gamma) : 1.0;
  return spread * mean / (4.0 * std::numbers::pi);
}

ZonalSh<double> point_spread_sh(double T) {
  // Both integrands bend sharply at ends of their intervals: at gamma = 0 within about 1/T, and at
  // x = 1 within about T. gamma = pi s^3 and x = q^2 (3 - 2 q) spread those ends out.
  static const QuadratureRule rule = gauss_legendre(96);
  const std::size_t n = rule.nodes.size();
  ZonalSh<double> result{};
  for (std::size_t i = 0; i < n; ++i) {
    const double s = 0.5 * (1.0 + rule.nodes[i]);
    const double gamma = std::numbers::pi * s * s * s;
    const double delta = std::numbers::pi - gamma;
    double mean = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      const double q = 0.5 * (1.0 + rule.nodes[k]);
      const double stretch = 3.0 * rule.weights[k] * q * (1.0 - q);
      mean += stretch * std::exp(-T * detour(delta, q * q * (3.0 - 2.0 * q)));
    }
    // 2 pi sin(gamma) point_spread dgamma, in which the singular sine drops out.
    const double mass = 0.5 * delta * mean * (1.5 * std::numbers::pi * rule.weights[i] * s * s);
    const ShVector<double> y =
        sh_basis(sh_most_bands, glm::dvec3(std::sin(gamma), 0.0, std::cos(gamma)));
    for (int l = 0; l < sh_most_bands; ++l) {
      result[static_cast<std::size_t>(l)] += mass * y[sh_index(l, 0)];
    }
  }
  return result;
}

namespace {

// Nodes stand at equal steps in log(1 + T / knee): the coefficients go like T log T near 0 and like
// log(T) / T far out. One node stands outside each end, for the cubic.
constexpr double knee = 1e-4;
constexpr double greatest = 100.0;
constexpr int intervals = 128;

double step() {
  return std::log1p(greatest / knee) / intervals;
}

}  // namespace

PointSpreadTable::PointSpreadTable() {
  for (int i = -1; i <= intervals + 1; ++i) {
    // The coefficients end at T = 0: the outer node there is an extrapolation.
    nodes_.push_back(point_spread_sh(knee * std::expm1(step() * std::max(i, 0))));
  }
  for (std::size_t l = 0; l < nodes_[0].size(); ++l) {
    nodes_[0][l] = 3.0 * nodes_[1][l] - 3.0 * nodes_[2][l] + nodes_[3][l];
  }
}

const PointSpreadTable& PointSpreadTable::shared() {
  static const PointSpreadTable table;
  return table;
}

ZonalSh<double> PointSpreadTable::operator()(double T) const {
  const double at = std::log1p(std::clamp(T, 0.0, greatest) / knee) / step();
  const double cell = std::min(std::floor(at), intervals - 1.0);
  const double t = at - cell;
  // Lagrange's cubic through the nodes at -1, 0, 1, 2.
  const std::array<double, 4> weights = {
      -t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
      -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0};
  ZonalSh<double> result{};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const ZonalSh<double>& node = nodes_[static_cast<std::size_t>(cell) + k];
    for (std::size_t l = 0; l < result.size(); ++l) result[l] += weights[k] * node[l];
  }
  return result;
}

}  // namespace brume
