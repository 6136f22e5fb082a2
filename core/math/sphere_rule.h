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

// A rule on the hemisphere z > 0 of at most `nodes` nodes, a multiple of 8 and at least 64. Exact,
// but for rounding, for spherical harmonics up to degree 7, and for those times z up to 6. Even
// enough for functions with edges: their error falls about like nodes^-3/4.
std::vector<SphereNode> hemisphere_rule(std::size_t nodes);

}  // namespace brume
