// The closed forms against quadrature, where careless arithmetic breaks.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/infinity.h"
#include "core/math/quadrature.h"
#include "core/math/special_functions.h"
#include "core/math/sphere_rule.h"
#include "core/transport/average_depth.h"
#include "core/transport/closed_form_airlight.h"
#include "core/transport/optical_depth.h"
#include "core/transport/point_spread.h"
#include "tests/core/transport/incident_light.h"
#include "tests/random.h"

namespace brume {
namespace {

TEST(Quadrature, IsExactForPolynomials) {
  // Kronrod 15 is exact up to degree 22.
  const auto f = [](double x) { return 23.0 * std::pow(x, 22) + 5.0 * std::pow(x, 4); };
  EXPECT_NEAR(gauss_kronrod_15<double>(f, 0.0, 1.0).value, 2.0, 1e-13);
}

TEST(Quadrature, FindsANarrowPeak) {
  const auto f = [](double x) { return std::exp(-std::pow((x - 0.317) / 1e-3, 2)); };
  const std::array<double, 3> breakpoints = {0.0, 0.316, 1.0};
  const auto result = integrate<double>(f, breakpoints, 1e-10);
  EXPECT_NEAR(result.value, 1e-3 * std::sqrt(std::numbers::pi), 1e-13);
  EXPECT_LE(result.error, 1e-10 * result.value);
}

TEST(SpecialFunctions, ErfcxMeetsItsBounds) {
  // DLMF 7.9.4 by brute force: erfcx(x) = 2/sqrt(pi) * integral of exp(-t^2 - 2 x t).
  for (double x = 0.0; x < 60.0; x += 0.173) {
    const auto f = [x](double t) { return std::exp(-t * t - 2.0 * x * t); };
    const std::array<double, 4> breakpoints = {0.0, 1.0 / (1.0 + x), 3.0 / (1.0 + x), 8.0};
    const double reference =
        2.0 * std::numbers::inv_sqrtpi * integrate<double>(f, breakpoints, 1e-15).value;
    EXPECT_NEAR(erfcx(x), reference, 2e-14 * reference) << x;
    EXPECT_NEAR(erfcx(static_cast<float>(x)), reference, 4e-6 * reference) << x;
  }
}

// T by quadrature of the density itself; the Gaussian's own stretch is a breakpoint.
double depth_by_quadrature(const GaussianTerm<double>& g, const glm::dvec3& A,
                           const glm::dvec3& B) {
  const double d = glm::length(B - A);
  const glm::dvec3 w = (B - A) / d;
  const double t0 = glm::dot(g.b - A, w);
  const auto f = [&](double t) {
    const glm::dvec3 q = A + t * w - g.b;
    return g.c * std::exp(-g.a * g.a * glm::dot(q, q));
  };
  std::vector<double> breakpoints{0.0};
  for (const double k : {-6.0, -3.0, -1.0, 0.0, 1.0, 3.0, 6.0}) {
    const double t = t0 + k / g.a;
    if (t > breakpoints.back() && t < d) breakpoints.push_back(t);
  }
  breakpoints.push_back(d);
  return integrate<double>(f, breakpoints, 1e-13).value;
}

struct SegmentRow {
  const char* name;
  double a_low, a_high;     // powers of ten
  double u0_low, u0_high;   // start, in radii from the projection
  double k_low, k_high;     // length, powers of ten of a radius
  double bound64, bound32;  // relative error
};

// Start and length are drawn in units of the Gaussian; h up to one radius. Bounds are those of
// math section 1 with the conditioning of the rounded inputs on top.
const SegmentRow rows[] = {
    {"across the centre", -1, 1, -5, -0.1, 0, 1, 1e-12, 1e-5},
    {"behind, beginning near", -1, 1, 0.1, 2, -1, 1, 1e-12, 2e-5},
    {"tail", -1, 1, 4, 5, -1, 0, 1e-11, 1e-4},
    {"deep tail", -1, 1, 5, 8, -1, 1, 1e-11, 3e-4},
    {"short", -1, 1, -2, 2, -6, -3, 1e-11, 1e-4},
    {"tiny a", -5, -4, -2, 2, -5, -3, 1e-11, 1e-4},
};

// Rounds to float in memory: GCC 12 at -O3 folds the conversion double -> float -> double of
// vectors away, and the two sides would not see the same inputs.
glm::vec3 rounded(const glm::dvec3& x) {
  volatile float xyz[3] = {static_cast<float>(x.x), static_cast<float>(x.y),
                           static_cast<float>(x.z)};
  return {xyz[0], xyz[1], xyz[2]};
}

TEST(OpticalDepth, MeetsItsErrorBoundInEveryBranch) {
  for (const SegmentRow& row : rows) {
    SCOPED_TRACE(row.name);
    Random random(21);
    double worst64 = 0.0;
    double worst32 = 0.0;
    for (int i = 0; i < 2000; ++i) {
      GaussianTerm<double> g(static_cast<float>(random.power(row.a_low, row.a_high)),
                             static_cast<float>(random.power(-1, 1)), glm::dvec3(0.0));
      const glm::dvec3 w = glm::normalize(random.point(1.0));
      const glm::dvec3 across = glm::normalize(glm::cross(w, random.point(1.0)));
      const double u0 = random.uniform(row.u0_low, row.u0_high);
      const double k = random.power(row.k_low, row.k_high);
      // Around the float inputs that both see.
      const glm::vec3 A32 = rounded(random.uniform(0.0, 1.0) / g.a * across + u0 / g.a * w);
      const glm::vec3 B32 = rounded(glm::dvec3(A32) + k / g.a * w);
      const glm::dvec3 A(A32);
      const glm::dvec3 B(B32);
      if (A32 == B32) continue;
      const double reference = depth_by_quadrature(g, A, B);
      if (reference < 1e-30) continue;
      worst64 = std::max(worst64, std::abs(optical_depth(g, A, B) / reference - 1.0));
      const GaussianTerm<float> g32(static_cast<float>(g.a), static_cast<float>(g.c), glm::vec3(0));
      worst32 = std::max(
          worst32, std::abs(static_cast<double>(optical_depth(g32, A32, B32)) / reference - 1.0));
    }
    EXPECT_LT(worst64, row.bound64);
    EXPECT_LT(worst32, row.bound32);
  }
}

TEST(OpticalDepth, IsZeroOverZeroLength) {
  const GaussianTerm<double> g(1.0, 1e6, {0, 0, 0});
  EXPECT_EQ(optical_depth(g, {0.1, 0, 0}, {0.1, 0, 0}), 0.0);
}

TEST(OpticalDepth, EndlessIsTheLimitOfLong) {
  const GaussianTerm<double> g(1.3, 2.0, {0.2, 0.1, 3.0});
  const glm::dvec3 o(0.0);
  const auto line = line_profile(g, o, {0, 0, 1});
  EXPECT_NEAR(optical_depth(g, line, infinity), optical_depth(g, o, {0, 0, 1e6}), 1e-14);
}

TEST(TruncatedMean, MatchesTheMeanOfTheDensity) {
  Random random(22);
  for (int i = 0; i < 2000; ++i) {
    const double a = random.power(-1, 1);
    const GaussianTerm<double> g(a, 1.0, {0, 0, random.uniform(-6, 6) / a});
    const double d = random.power(-5, 1.2) / a;
    const auto line = line_profile(g, glm::dvec3(0.0), glm::dvec3(0, 0, 1));
    const double near = std::clamp(g.b.z, 0.0, d);
    const auto weight = [&](double t) {
      // Scaled by its largest value on the segment, which may be beyond exp's range.
      return std::exp(-a * a * ((t - g.b.z) * (t - g.b.z) - (near - g.b.z) * (near - g.b.z)));
    };
    const auto moment = [&](double t) { return t * weight(t); };
    std::vector<double> breakpoints{0.0};
    for (const double t : {near - 1.0 / a, near - 0.1 / a, near, near + 0.1 / a, near + 1.0 / a}) {
      if (t > breakpoints.back() && t < d) breakpoints.push_back(t);
    }
    breakpoints.push_back(d);
    const double reference = integrate<double>(moment, breakpoints, 1e-12).value /
                             integrate<double>(weight, breakpoints, 1e-12).value;
    ASSERT_NEAR(truncated_mean(line, d), reference, 1e-9 * d) << "a " << a << " b " << g.b.z;
  }
  // Far behind: the density piles up at the near end, with the limit 1 / (2 a^2 |b|).
  const GaussianTerm<double> far(1.0, 1.0, {0, 0, -1e4});
  EXPECT_NEAR(truncated_mean(line_profile(far, {0, 0, 0}, {0, 0, 1}), 10.0), 0.5e-4, 1e-11);
}

// The bound behind all culling: a segment that misses the sphere is below the tolerance.
TEST(Reach, NothingOutsideReachesTheTolerance) {
  Random random(23);
  int culled = 0;
  double max_ratio = 0.0;
  for (int i = 0; i < 50000; ++i) {
    const Gaussian g{random.point(1.0), random.power(-2, 1), random.power(-2, 2)};
    const double eps = random.power(-6, -1);
    const double r = cutoff_radius(g.radius, g.density, eps);
    const glm::dvec3 A = random.point(5.0);
    const glm::dvec3 B = random.point(5.0);
    const glm::dvec3 w = glm::normalize(B - A);
    const double t = std::clamp(glm::dot(g.center - A, w), 0.0, glm::length(B - A));
    if (glm::length(g.center - A - t * w) <= r) continue;
    ++culled;
    max_ratio = std::max(max_ratio, optical_depth(g, A, B) / eps);
  }
  EXPECT_LE(max_ratio, 1.0);
  EXPECT_GT(max_ratio, 0.9) << "the bound is tight";
  EXPECT_GT(culled, 10000);
}

TEST(HomogeneousAirlight, HasNoSingularities) {
  const glm::dvec3 eye(0.0);
  const glm::dvec3 w(0, 0, 1);
  const auto airlight = [&](double b0, const glm::dvec3& light, double d, double h_min = 0.0) {
    return homogeneous_airlight(b0, PointLightRay<double>(light, eye, w, h_min), d);
  };
  const double k = 1.0 / (4.0 * std::numbers::pi);
  // The light straight ahead, behind the surface: math section 2, limit g -> 0.
  const double ahead = 0.7 * k * std::exp(-0.7 * 5.0) * (1.0 / (5.0 - 2.0) - 1.0 / 5.0);
  EXPECT_NEAR(airlight(0.7, {0, 0, 5}, 2.0), ahead, 1e-10 * ahead);
  EXPECT_NEAR(airlight(0.7, {1e-9, 0, 5}, 2.0), ahead, 1e-9 * ahead);
  // Thin limit: b0 / (4 pi h) times the angle that the ray spans at the light.
  const double thin = 1e-9 * k / 2.0 * (0.5 * std::numbers::pi);
  EXPECT_NEAR(airlight(1e-9, {0, 2, 0}, infinity), thin, 1e-6 * thin);
  // Dense, light behind the eye: the published closed form overflows here.
  EXPECT_GT(airlight(1.0, {0, 0.1, -300}, 10.0), 0.0);
  EXPECT_LT(airlight(1.0, {0, 0.1, -300}, 10.0), 1e-100);
  // Through the light: ~ b0 / (4 h) while h is small.
  EXPECT_NEAR(airlight(0.1, {0, 0, 3}, 10.0, 1e-6), 0.1 * std::exp(-0.3) / (4e-6), 0.1);
  // No fog, no way.
  EXPECT_EQ(airlight(0.0, {0, 1, 2}, 10.0), 0.0);
  EXPECT_EQ(airlight(1.0, {0, 1, 2}, 0.0), 0.0);
}

TEST(GaussianAirlight, NeverOverflows) {
  // exp(+T) of the paper's factors would: T_i is 1e6 here.
  const GaussianTerm<double> g(1.0, 1e6, {0, 0, 5});
  const glm::dvec3 eye(0.0);
  const glm::dvec3 w(0, 0, 1);
  const glm::dvec3 light(0, 3, 5);
  const double value =
      gaussian_airlight(g, eye, w, infinity, light, PointLightRay<double>(light, eye, w, 0.0), 2.0);
  EXPECT_TRUE(std::isfinite(value));
  EXPECT_GE(value, 0.0);
}

// The light that reaches surfaces: point spread, average depth, their spherical harmonics.

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

// This is its definition: light along -z meets the view ray at t after a path r in the ball.
double distant_spread(double T, double gamma) {
  const auto attenuation = [&](double t) {
    const double x = t * std::sin(gamma);
    const double r = std::sqrt(std::max(0.0, 1.0 - x * x)) - t * std::cos(gamma);
    return std::exp(-T * (t + r - 1.0));
  };
  const std::array<double, 2> all = {0.0, 1.0};
  return integrate<double>(attenuation, all, 1e-11).value / (4.0 * std::numbers::pi);
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
