#include "core/math/sphere_rule.h"

#include <cmath>
#include <numbers>

namespace brume {

QuadratureRule gauss_legendre(std::size_t n) {
  QuadratureRule rule{std::vector<double>(n), std::vector<double>(n)};
  const auto degree = static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    // Newton's method on the Legendre polynomial P_n, from Tricomi's estimate of its root.
    double x = -std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (degree + 0.5));
    double slope = 1.0;
    for (int step = 0; step < 10; ++step) {
      double before = 1.0;
      double p = x;
      for (std::size_t k = 1; k < n; ++k) {
        const auto l = static_cast<double>(k);
        const double next = ((2.0 * l + 1.0) * x * p - l * before) / (l + 1.0);
        before = p;
        p = next;
      }
      slope = degree * (before - x * p) / ((1.0 - x) * (1.0 + x));
      const double change = p / slope;
      x -= change;
      if (std::abs(change) < 1e-15) break;
    }
    rule.nodes[i] = x;
    rule.weights[i] = 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope);
  }
  return rule;
}

std::vector<SphereNode> sphere_rule(int degree) {
  const QuadratureRule z = gauss_legendre(static_cast<std::size_t>(degree / 2 + 1));
  const int azimuths = degree + 1;
  const double step = 2.0 * std::numbers::pi / azimuths;
  std::vector<SphereNode> nodes;
  nodes.reserve(z.nodes.size() * static_cast<std::size_t>(azimuths));
  for (std::size_t i = 0; i < z.nodes.size(); ++i) {
    const double r = std::sqrt((1.0 - z.nodes[i]) * (1.0 + z.nodes[i]));
    for (int k = 0; k < azimuths; ++k) {
      const double phi = step * k;
      nodes.push_back({{r * std::cos(phi), r * std::sin(phi), z.nodes[i]}, step * z.weights[i]});
    }
  }
  return nodes;
}

std::vector<SphereNode> hemisphere_rule(std::size_t nodes) {
  constexpr std::size_t azimuths = 8;
  const std::size_t rings = nodes / azimuths;
  const QuadratureRule rule = gauss_legendre(rings);
  constexpr double step = 2.0 * std::numbers::pi / static_cast<double>(azimuths);
  std::vector<SphereNode> result;
  result.reserve(rings * azimuths);
  for (std::size_t i = 0; i < rings; ++i) {
    const double z = 0.5 * (1.0 + rule.nodes[i]);
    const double r = std::sqrt((1.0 - z) * (1.0 + z));
    // Rings are turned against each other by the golden section, so that no edge along a meridian
    // passes many of them at once; few nodes to a ring, so that none along a ring does.
    const double turn = static_cast<double>(i) / std::numbers::phi;
    for (std::size_t k = 0; k < azimuths; ++k) {
      const double phi = step * (static_cast<double>(k) + turn);
      result.push_back({{r * std::cos(phi), r * std::sin(phi), z}, 0.5 * step * rule.weights[i]});
    }
  }
  return result;
}

}  // namespace brume
