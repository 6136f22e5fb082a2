#include "core/math/spherical_harmonics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/math/sphere_rule.h"
#include "core/scene/materials/brdf.h"
#include "tests/core/math/sh_convolve.h"
#include "tests/random.h"

namespace brume {
namespace {

TEST(HemisphereRule, IsExactForLowBands) {
  for (const std::size_t nodes : {64u, 256u, 1000u}) {
    const std::vector<SphereNode> rule = hemisphere_rule(nodes);
    EXPECT_EQ(rule.size(), nodes);
    ShVector<double> sum(6);
    ShVector<double> cosine(6);
    for (const SphereNode& node : rule) {
      EXPECT_GT(node.direction.z, 0.0);
      EXPECT_NEAR(glm::length(node.direction), 1.0, 1e-14);
      const ShVector<double> y = sh_basis(6, node.direction);
      for (std::size_t i = 0; i < y.size(); ++i) {
        sum[i] += node.weight * y[i];
        cosine[i] += node.weight * node.direction.z * y[i];
      }
    }
    // sqrt(pi (2 l + 1)) times the integral of P_l over [0, 1].
    const std::array<double, 6> legendre = {1.0, 0.5, 0.0, -0.125, 0.0, 0.0625};
    for (int l = 0; l < 6; ++l) {
      for (int m = -l; m <= l; ++m) {
        const auto band = static_cast<std::size_t>(l);
        const double expected = std::sqrt(std::numbers::pi * (2.0 * l + 1.0)) * legendre[band];
        EXPECT_NEAR(sum[sh_index(l, m)], m == 0 ? expected : 0.0, 1e-13);
        EXPECT_NEAR(cosine[sh_index(l, m)], m == 0 ? clamped_cosine_sh()[band] : 0.0, 1e-13);
      }
    }
  }
}

TEST(GaussLegendre, IsExactUpToItsDegree) {
  for (std::size_t n = 1; n <= 64; ++n) {
    const QuadratureRule rule = gauss_legendre(n);
    const int degree = static_cast<int>(2 * n) - 2;
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
    EXPECT_NEAR(sum, 2.0 / (degree + 1.0), 1e-14) << n;
  }
}

glm::dvec3 random_direction(Random& random) {
  return glm::normalize(random.point(1.0));
}

ShVector<double> random_function(Random& random, int order) {
  ShVector<double> f(order);
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = random.uniform(-1.0, 1.0);
  return f;
}

TEST(SphericalHarmonics, MatchTheStandardLibraryUpToPhase) {
  Random random(3);
  double worst = 0.0;
  double worst32 = 0.0;
  for (int n = 0; n < 500; ++n) {
    const glm::dvec3 d = random_direction(random);
    const double theta = std::acos(d.z);
    const double phi = std::atan2(d.y, d.x);
    const ShVector<double> y = sh_basis(6, d);
    const ShVector<float> y32 = sh_basis(6, glm::vec3(d));
    for (int l = 0; l < 6; ++l) {
      for (int m = -l; m <= l; ++m) {
        const auto k = static_cast<unsigned>(std::abs(m));
        const double legendre =
            std::sph_legendre(static_cast<unsigned>(l), k, theta) * (k % 2 == 1 ? -1.0 : 1.0);
        const double turn = m > 0   ? std::sqrt(2.0) * std::cos(k * phi)
                            : m < 0 ? std::sqrt(2.0) * std::sin(k * phi)
                                    : 1.0;
        const std::size_t i = sh_index(l, m);
        worst = std::max(worst, std::abs(y[i] - legendre * turn));
        worst32 = std::max(worst32, std::abs(static_cast<double>(y32[i]) - legendre * turn));
      }
    }
  }
  EXPECT_LT(worst, 2e-14);  // acos and the library's own rounding are in this
  EXPECT_LT(worst32, 3e-6);
}

TEST(SphericalHarmonics, LowerOrdersAreTheBeginningOfHigherOnes) {
  const glm::dvec3 d = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  const ShVector<double> all = sh_basis(6, d);
  for (int order = 1; order < 6; ++order) {
    const ShVector<double> some = sh_basis(order, d);
    ASSERT_EQ(some.values().size(), sh_size(order));
    for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i], all[i]);
  }
}

TEST(SphericalHarmonics, HaveTheValuesAtThePoles) {
  const ShVector<double> y = sh_basis(6, glm::dvec3(0, 0, -1));
  for (int l = 0; l < 6; ++l) {
    for (int m = -l; m <= l; ++m) {
      const double sign = l % 2 == 0 ? 1.0 : -1.0;
      const double value = m == 0 ? sign * std::sqrt((2 * l + 1) / (4 * std::numbers::pi)) : 0.0;
      EXPECT_NEAR(y[sh_index(l, m)], value, 1e-15) << l << ' ' << m;
    }
  }
}

TEST(SphericalHarmonics, RotateAsTheFunctionDoes) {
  Random random(4);
  for (int order = 1; order <= 6; ++order) {
    const ShVector<double> f = random_function(random, order);
    const glm::dquat q =
        glm::normalize(glm::dquat(0.3, random.uniform(-1, 1), random.uniform(-1, 1), 0.2));
    const ShVector<double> turned = sh_rotate(f, q);
    for (int n = 0; n < 20; ++n) {
      const glm::dvec3 d = random_direction(random);
      EXPECT_NEAR(sh_evaluate(turned, q * d), sh_evaluate(f, d), 2e-14);
    }
  }
  const ShVector<double> f = random_function(random, 6);
  const ShVector<double> same = sh_rotate(f, glm::dquat(1, 0, 0, 0));
  const ShVector<double> around = sh_rotate(f, glm::dquat(0, 0, 0, 1));
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(same[i], f[i], 1e-14);
  const glm::dvec3 d = random_direction(random);
  EXPECT_NEAR(sh_evaluate(around, {-d.x, -d.y, d.z}), sh_evaluate(f, d), 1e-14);
  // +90 degrees about +y takes +z to +x.
  ShVector<double> z(2);
  z[sh_index(1, 0)] = 1.0;
  const ShVector<double> x =
      sh_rotate(z, glm::angleAxis(0.5 * std::numbers::pi, glm::dvec3(0, 1, 0)));
  EXPECT_NEAR(x[sh_index(1, 1)], 1.0, 1e-15);
  EXPECT_NEAR(x[sh_index(1, 0)], 0.0, 1e-15);
}

TEST(SphericalHarmonics, ConvolveAsTheIntegralDoes) {
  Random random(5);
  const ShVector<double> f = random_function(random, 6);
  const ZonalSh<double> g = {0.5, -0.3, 0.2, 0.7, 0.1, -0.4};
  ShVector<double> kernel(6);
  for (int l = 0; l < 6; ++l) kernel[sh_index(l, 0)] = g[static_cast<std::size_t>(l)];
  const ShVector<double> convolved = sh_convolve(f, g);
  const std::vector<SphereNode> rule = sphere_rule(10);
  for (int n = 0; n < 10; ++n) {
    const glm::dvec3 d = random_direction(random);
    double integral = 0.0;
    for (const SphereNode& node : rule) {
      const double z = glm::dot(d, node.direction);
      const glm::dvec3 seen(std::sqrt(std::max(0.0, 1.0 - z * z)), 0.0, z);
      integral += node.weight * sh_evaluate(f, node.direction) * sh_evaluate(kernel, seen);
    }
    EXPECT_NEAR(sh_evaluate(convolved, d), integral, 1e-13);
  }
}

TEST(SphericalHarmonics, TriplesAreAsManyAsCountedElsewhere) {
  EXPECT_EQ(sh_triples(1).size(), 1u);
  EXPECT_EQ(sh_triples(3).size(), 83u);
  EXPECT_EQ(sh_triples(4).size(), 353u);
  EXPECT_EQ(sh_triples(5).size(), 1158u);
  EXPECT_EQ(sh_triples(6).size(), 2907u);
}

TEST(SphericalHarmonics, ProductIsTheProductOfTheFunctions) {
  // Two functions of three bands have a product of five, which five bands hold whole.
  Random random(6);
  ShVector<double> f(5);
  ShVector<double> g(5);
  for (std::size_t i = 0; i < sh_size(3); ++i) {
    f[i] = random.uniform(-1.0, 1.0);
    g[i] = random.uniform(-1.0, 1.0);
  }
  const ShVector<double> product = sh_product(f, g);
  for (int n = 0; n < 20; ++n) {
    const glm::dvec3 d = random_direction(random);
    EXPECT_NEAR(sh_evaluate(product, d), sh_evaluate(f, d) * sh_evaluate(g, d), 1e-13);
  }
}

}  // namespace
}  // namespace brume
