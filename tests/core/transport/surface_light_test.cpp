// The light that reaches surfaces: point spread, average depth, their spherical harmonics.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/math/infinity.h"
#include "core/math/quadrature.h"
#include "core/math/sphere_rule.h"
#include "core/transport/average_depth.h"
#include "core/transport/homogeneous_airlight.h"
#include "core/transport/point_spread.h"
#include "tests/core/transport/incident_light.h"
#include "tests/random.h"

namespace brume {
namespace {

TEST(PointSpread, MatchesTheAirlightOfAHomogeneousMedium) {
  Random random(11);
  for (int n = 0; n < 200; ++n) {
    const double T = random.power(-4, 1.5);
    const double gamma = random.uniform(1e-3, std::numbers::pi - 1e-3);
    const double D = random.power(-1, 1);
    const glm::dvec3 w(std::sin(gamma), 0.0, std::cos(gamma));
    const PointLightRay<double> path({0, 0, D}, glm::dvec3(0), w, 0.0);
    const double airlight = homogeneous_airlight(T / D, path, infinity);
    EXPECT_NEAR(T * std::exp(-T) * point_spread(T, gamma), airlight * D * D,
                2e-10 * airlight * D * D)
        << T << ' ' << gamma;
  }
}

TEST(PointSpread, MatchesItsLimits) {
  EXPECT_NEAR(point_spread(0.5, 1e-9) * 4e-9, 1.0, 1e-7);
  EXPECT_NEAR(point_spread(0.0, 1.0),
              (std::numbers::pi - 1.0) / (4 * std::numbers::pi * std::sin(1.0)), 1e-12);
  // Straight away from the light it is smooth.
  EXPECT_NEAR(point_spread(2.0, std::numbers::pi), point_spread(2.0, std::numbers::pi - 1e-7),
              1e-7);
  EXPECT_EQ(point_spread(1e6, 3.0) >= 0.0, true);
}

TEST(PointSpread, CoefficientsAreThoseOfTheFunction) {
  // By adaptive quadrature, where point_spread_sh() has a fixed rule.
  const std::array<double, 4> breakpoints = {0.0, 0.01, 0.3, std::numbers::pi};
  for (const double T : {1e-3, 0.1, 1.0, 10.0, 100.0}) {
    const ZonalSh<double> coefficients = point_spread_sh(T);
    for (int l = 0; l < sh_max_bands; ++l) {
      const auto f = [&](double gamma) {
        const glm::dvec3 d(std::sin(gamma), 0.0, std::cos(gamma));
        return 2 * std::numbers::pi * d.x * point_spread(T, gamma) *
               sh_basis(sh_max_bands, d)[sh_index(l, 0)];
      };
      const double reference = integrate<double>(f, breakpoints, 1e-11).value;
      EXPECT_NEAR(coefficients[static_cast<std::size_t>(l)], reference, 2e-9 * reference)
          << T << ' ' << l;
    }
  }
}

TEST(PointSpread, TableMeetsItsErrorBound) {
  const SpreadTable& table = SpreadTable::point();
  const auto expect_close = [&](double T) {
    const ZonalSh<double> exact = point_spread_sh(T);
    const ZonalSh<double> got = table(T);
    for (std::size_t l = 0; l < exact.size(); ++l) {
      EXPECT_NEAR(got[l], exact[l], 2e-6 * exact[l]) << T << ' ' << l;
    }
  };
  expect_close(0.0);
  for (double T = 1e-7; T < 100.0; T *= 1.057) expect_close(T);
  EXPECT_EQ(table(1e9), table(100.0));
}

TEST(DistantSpread, IntegratesToOneInThinMedia) {
  const ZonalSh<double> thin = distant_spread_sh(0.0);
  EXPECT_NEAR(thin[0], 1.0 / std::sqrt(4 * std::numbers::pi), 1e-12);
  for (std::size_t l = 1; l < thin.size(); ++l) EXPECT_NEAR(thin[l], 0.0, 1e-12);
}

TEST(DistantSpread, CoefficientsAreThoseOfTheFunction) {
  const std::array<double, 4> breakpoints = {0.0, 0.01, 0.3, std::numbers::pi};
  for (const double T : {1e-3, 0.3, 3.0, 100.0}) {
    const ZonalSh<double> coefficients = distant_spread_sh(T);
    for (int l = 0; l < sh_max_bands; ++l) {
      const auto f = [&](double gamma) {
        const glm::dvec3 d(std::sin(gamma), 0.0, std::cos(gamma));
        return 2 * std::numbers::pi * d.x * distant_spread(T, gamma) *
               sh_basis(sh_max_bands, d)[sh_index(l, 0)];
      };
      const double reference = integrate<double>(f, breakpoints, 1e-11, 1e-13).value;
      EXPECT_NEAR(coefficients[static_cast<std::size_t>(l)], reference, 2e-9 * coefficients[0])
          << T << ' ' << l;
    }
  }
}

TEST(DistantSpread, TableMeetsItsErrorBound) {
  for (double T = 1e-7; T < 100.0; T *= 1.057) {
    const ZonalSh<double> exact = distant_spread_sh(T);
    const ZonalSh<double> got = SpreadTable::distant()(T);
    for (std::size_t l = 0; l < exact.size(); ++l) {
      EXPECT_NEAR(got[l], exact[l], 4e-6 * exact[0]) << T << ' ' << l;
    }
  }
}

TEST(PointSpread, MatchesThePaperAtOpticalDepthOne) {
  const ZonalSh<double> exact = point_spread_sh(1.0);
  for (std::size_t l = 0; l < exact.size(); ++l) {
    EXPECT_NEAR(paper_point_spread_sh[l], exact[l], 3e-5);
  }
}

TEST(AverageDepth, MatchesDawsonsFunction) {
  // sqrt(pi) / 2 D(u) / u with 20 digits, by mpmath.
  constexpr std::array<std::array<double, 2>, 13> reference = {{{0.001, 0.88622633463504403892},
                                                                {0.05, 0.88475135656743298005},
                                                                {0.2, 0.86296804765247491391},
                                                                {0.5, 0.75229390240256984904},
                                                                {1.3, 0.32953838123342218115},
                                                                {2.65, 0.0692726545105697423},
                                                                {3.7, 0.03371283251085686978},
                                                                {4.6, 0.021476027350971660359},
                                                                {5, 0.018102793352198005176},
                                                                {6.5, 0.010616701201805630617},
                                                                {8, 0.0069790590504384822594},
                                                                {30, 0.00049262227589636770718},
                                                                {1000, 4.4311368428344270594e-7}}};
  for (const auto& [u, value] : reference) {
    EXPECT_NEAR(unit_average_depth(u), value, 2e-15 * value) << u;
    // The input's own rounding to float adds 2 epsilon.
    EXPECT_NEAR(unit_average_depth(static_cast<float>(u)), value, 8e-7 * value) << u;
  }
  EXPECT_NEAR(unit_average_depth(1e12) * 4e24 / std::sqrt(std::numbers::pi), 1.0, 1e-14);
  EXPECT_GE(unit_average_depth(1e30f), 0.0f);
}

TEST(AverageDepth, MatchesTheMeanOverTheSphere) {
  Medium medium;
  medium.append({{0.3, -0.2, 0.5}, 0.8, 1.7});
  medium.append({{-1.0, 0.4, 0.1}, 1.5, 0.3});
  medium.set_homogeneous_density(0.05);
  const glm::dvec3 p(0.1, 0.6, -0.3);
  double mean = 10.0 * 0.05;
  for (const SphereNode& node : sphere_rule(80)) {
    for (std::size_t i = 0; i < medium.size(); ++i) {
      const StandaloneTerm term(medium.gaussian(i));
      const GaussianTerm<double>& g = *term;
      mean += node.weight / (4 * std::numbers::pi) *
              optical_depth(g, line_profile(g, p, node.direction), infinity);
    }
  }
  EXPECT_NEAR(average_depth(medium, 10.0, p), mean, 1e-12 * mean);
}

TEST(IncidentLight, ConstantEnvironmentIsIsotropic) {
  ShVector<glm::dvec3> L(4);
  L[0] = glm::dvec3(1, 2, 3) * std::sqrt(4 * std::numbers::pi);
  const double T = 0.7;
  const ZonalSh<double> spread = SpreadTable::distant()(T);
  const ShVector<glm::dvec3> light = incident_environment(L, T, spread);
  const double mass = spread[0] * std::sqrt(4 * std::numbers::pi);  // integral of the spread
  const double radiance = std::exp(-T) * (T * mass + 1.0);
  EXPECT_NEAR(sh_evaluate(light, glm::dvec3(0, 1, 0)).y, 2.0 * radiance, 1e-12);
  EXPECT_EQ(light[5], glm::dvec3(0.0));
}

}  // namespace
}  // namespace brume
