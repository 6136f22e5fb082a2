#include "core/authoring/gaussian_moments.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "core/medium/gaussian_covariance.h"

namespace brume {
namespace {

double volume_over_density(double mean_radius) {
  return std::pow(std::numbers::pi, 1.5) * mean_radius * mean_radius * mean_radius;
}

double trace(const glm::dmat3& m) {
  return m[0][0] + m[1][1] + m[2][2];
}

// The trace of the inverse of a symmetric matrix, times its determinant.
double adjugate_trace(const glm::dmat3& m) {
  return glm::cross(m[1], m[2]).x + glm::cross(m[2], m[0]).y + glm::cross(m[0], m[1]).z;
}

// L D L^T of a covariance: unlike its determinant it loses nothing where that is far below the
// cube of the greatest variance.
struct Factors {
  double l10, l20, l21;
  glm::dvec3 d;  // >= least

  Factors(const glm::dmat3& s, double least) {
    d[0] = std::max(s[0][0], least);
    l10 = s[0][1] / d[0];
    l20 = s[0][2] / d[0];
    d[1] = std::max(s[1][1] - l10 * s[0][1], least);
    l21 = (s[1][2] - l20 * s[0][1]) / d[1];
    d[2] = std::max(s[2][2] - l20 * s[0][2] - l21 * l21 * d[1], least);
  }
  [[nodiscard]] double determinant() const { return d[0] * d[1] * d[2]; }
  // v^T S^-1 v
  [[nodiscard]] double square_of(const glm::dvec3& v) const {
    const double y = v[1] - l10 * v[0];
    const double z = v[2] - l20 * v[0] - l21 * y;
    return v[0] * v[0] / d[0] + y * y / d[1] + z * z / d[2];
  }
};

// The product of two Gaussians' depths as a function of t: what is the same for each t.
struct Product {
  double masses;
  // det(I + t S) and d^T adj(I + t S) d are polynomials.
  double s1, s2, s3;
  double d0, d1, d2;

  Product(const GaussianMoments& a, const GaussianMoments& b) : masses(a.mass * b.mass) {
    const glm::dmat3 s = a.covariance + b.covariance;
    const glm::dvec3 d = b.center - a.center;
    s1 = trace(s);
    // A variance is at least so much of another: limits::min_stretch, squared.
    const Factors factors(s, 1e-9 * s1);
    s2 = std::max(adjugate_trace(s), 0.0);
    s3 = factors.determinant();
    d0 = glm::dot(d, d);
    d1 = std::max(s1 * d0 - glm::dot(d, s * d), 0.0);
    d2 = s3 * factors.square_of(d);
  }

  [[nodiscard]] double at(double t) const {
    const double determinant = 1.0 + t * (s1 + t * (s2 + t * s3));
    const double square = (d0 + t * (d1 + t * d2)) / determinant;
    return masses * std::exp(-0.5 * t * square) / std::sqrt(determinant);
  }
  // From it on the integrand decays as t^(-1/2) in ln t, and up to it as t.
  [[nodiscard]] double end() const { return 100.0 * s2 / s3; }
  [[nodiscard]] double begin() const { return 0.01 / (s1 + d0); }
};

}  // namespace

GaussianMoments::GaussianMoments(const Gaussian& g)
    : mass(g.density * volume_over_density(g.mean_radius())),
      center(g.center),
      covariance(covariance_of(g)) {}

GaussianMoments::GaussianMoments(const GaussianMoments& a, const GaussianMoments& b)
    : mass(a.mass + b.mass) {
  const double share = mass > 0.0 ? b.mass / mass : 0.5;
  const glm::dvec3 apart = b.center - a.center;
  center = a.center + share * apart;
  covariance = (1.0 - share) * a.covariance + share * b.covariance +
               share * (1.0 - share) * glm::outerProduct(apart, apart);
}

void GaussianMoments::make_round() {
  covariance = glm::dmat3(trace(covariance) / 3.0);
}

void GaussianMoments::apply_to(Gaussian& gaussian) const {
  gaussian.center = center;
  set_covariance(gaussian, covariance);
  gaussian.density = mass / volume_over_density(gaussian.mean_radius());
}

double squared_error(const GaussianMoments& a, const GaussianMoments& b,
                     const GaussianMoments& one) {
  // By the trapezoidal rule over ln t, with the same t for all products: for each t their sum is
  // a square, so that nothing is lost where they cancel.
  constexpr double step = 1.5;
  const Product products[]{{a, a}, {b, b}, {one, one}, {a, b}, {a, one}, {b, one}};
  constexpr double times[]{1.0, 1.0, 1.0, 2.0, -2.0, -2.0};
  double begin = products[0].begin();
  double end = 0.0;
  for (const Product& product : products) {
    begin = std::min(begin, product.begin());
    end = std::max(end, product.end());
  }
  const int nodes = 2 + std::max(0, static_cast<int>(std::log(end / begin) / step));
  const double factor = std::exp(step);
  double sum = 0.0;
  double t = begin;
  for (int i = 0; i < nodes; ++i, t *= factor) {
    double value = 0.0;
    for (std::size_t k = 0; k < 6; ++k) value += times[k] * products[k].at(t);
    // Beyond the ends it is a geometric series.
    if (i == 0) value /= 1.0 - 1.0 / factor;
    if (i + 1 == nodes) value /= 1.0 - std::sqrt(1.0 / factor);
    sum += std::max(value, 0.0) * t;
  }
  return step * sum / (4.0 * std::numbers::pi);
}

}  // namespace brume
