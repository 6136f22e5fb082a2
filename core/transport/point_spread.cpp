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

// The same for parallel light, x = t.
double distant_detour(double gamma, double x) {
  const double half_sine = std::sin(0.5 * gamma);
  const double across = x * std::sin(gamma);  // of the ball's radius, the distance off the light
  const double sunk = across * across / (1.0 + std::sqrt(std::max(0.0, 1.0 - across * across)));
  return 2.0 * x * half_sine * half_sine - sunk;
}

// The mean of exp(-T detour(x)) over x in [0, 1].
template <class Detour>
double mean_attenuation(double T, const Detour& detour) {
  const auto attenuation = [&](double x) { return std::exp(-T * detour(x)); };
  const std::array<double, 2> all = {0.0, 1.0};
  return integrate<double>(attenuation, all, 1e-12).value;
}

// A Gauss-Legendre rule on [0, 1] with its nodes moved further towards both ends, where integrands
// bend within a small stretch.
QuadratureRule towards_both_ends(std::size_t n) {
  QuadratureRule rule = gauss_legendre(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double q = 0.5 * (1.0 + rule.nodes[i]);
    rule.nodes[i] = q * q * (3.0 - 2.0 * q);
    rule.weights[i] *= 3.0 * q * (1.0 - q);
  }
  return rule;
}

// The coefficients of a spread that is factor(gamma) / (4 pi sin gamma) times that mean.
template <class Factor, class Detour>
ZonalSh<double> project(double T, const Factor& factor, const Detour& detour) {
  // The mean has high curvature within 1/T of gamma = 0 and, for parallel light, of pi/2; its
  // integrand within T of x = 1.
  static const QuadratureRule gammas = towards_both_ends(64);  // of each quarter turn
  static const QuadratureRule xs = towards_both_ends(96);
  const double quarter = 0.5 * std::numbers::pi;
  ZonalSh<double> result{};
  for (std::size_t i = 0; i < 2 * gammas.nodes.size(); ++i) {
    const double gamma = quarter * (static_cast<double>(i % 2) + gammas.nodes[i / 2]);
    double mean = 0.0;
    for (std::size_t k = 0; k < xs.nodes.size(); ++k) {
      mean += xs.weights[k] * std::exp(-T * detour(gamma, xs.nodes[k]));
    }
    // 2 pi sin(gamma) spread dgamma, in which the sine drops out.
    const double weight = 0.5 * factor(gamma) * mean * quarter * gammas.weights[i / 2];
    const ShVector<double> y =
        sh_basis(sh_max_bands, glm::dvec3(std::sin(gamma), 0.0, std::cos(gamma)));
    for (int l = 0; l < sh_max_bands; ++l) {
      result[static_cast<std::size_t>(l)] += weight * y[sh_index(l, 0)];
    }
  }
  return result;
}

}  // namespace

double point_spread(double T, double gamma) {
  const double delta = std::numbers::pi - gamma;
  const double spread = delta > 0.0 ? delta / std::sin(gamma) : 1.0;
  return spread * mean_attenuation(T, [&](double x) { return detour(delta, x); }) /
         (4.0 * std::numbers::pi);
}

ZonalSh<double> point_spread_sh(double T) {
  return project(
      T, [](double gamma) { return std::numbers::pi - gamma; },
      [](double gamma, double x) { return detour(std::numbers::pi - gamma, x); });
}

ZonalSh<double> distant_spread_sh(double T) {
  return project(
      T, [](double gamma) { return std::sin(gamma); }, distant_detour);
}

namespace {

// Nodes at equal steps in log(1 + T / knee): the coefficients behave like T log T near 0 (those of
// a point) and like log(T) / T for large T. One node lies outside each end, for the cubic.
constexpr double knee = 1e-4;
constexpr double max_depth = 100.0;
constexpr int intervals = 128;

double step() {
  return std::log1p(max_depth / knee) / intervals;
}

}  // namespace

SpreadTable::SpreadTable(ZonalSh<double> (*exact)(double)) {
  for (int i = -1; i <= intervals + 1; ++i) {
    // The coefficients end at T = 0: the outer node there is an extrapolation.
    nodes_.push_back(exact(knee * std::expm1(step() * std::max(i, 0))));
  }
  for (std::size_t l = 0; l < nodes_[0].size(); ++l) {
    nodes_[0][l] = 3.0 * nodes_[1][l] - 3.0 * nodes_[2][l] + nodes_[3][l];
  }
}

const SpreadTable& SpreadTable::point() {
  static const SpreadTable table(point_spread_sh);
  return table;
}

const SpreadTable& SpreadTable::distant() {
  static const SpreadTable table(distant_spread_sh);
  return table;
}

ZonalSh<double> SpreadTable::operator()(double T) const {
  const double coordinate = std::log1p(std::clamp(T, 0.0, max_depth) / knee) / step();
  const double cell = std::min(std::floor(coordinate), intervals - 1.0);
  const double t = coordinate - cell;
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
