#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace brume {

// Nodes in ascending order and weights of a quadrature rule on an interval.
struct QuadratureRule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

// The n-point Gauss-Legendre rule on [-1, 1], n >= 1: exact for polynomials up to degree 2 n - 1,
// nodes and weights to about 1e-15.
QuadratureRule gauss_legendre(std::size_t n);

// A direction with its solid angle [sr].
struct SphereNode {
  glm::dvec3 direction;  // unit
  double weight;
};

// A rule on the sphere that is exact, but for rounding, for spherical harmonics up to `degree`:
// Gauss-Legendre in z times equal steps in azimuth.
std::vector<SphereNode> sphere_rule(int degree);

}  // namespace brume
