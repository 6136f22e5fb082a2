#include "core/authoring/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/authoring/gaussian_moments.h"
#include "core/transport/average_depth.h"
#include "tests/fog_bank.h"

namespace brume {
namespace {

TEST(Simplify, ErrorsAreAsEstimated) {
  std::size_t last = 3001;
  for (const double max_error : {0.01, 0.03, 0.1}) {
    const std::vector<Gaussian> bank = fog_bank(3000, 0.8, 5);
    const Simplified less = *simplify(medium_of(bank), {max_error});
    const std::vector<Gaussian> left = less.of(medium_of(bank));
    SCOPED_TRACE(testing::Message() << max_error << ": " << left.size());
    EXPECT_LT(left.size(), last);
    last = left.size();
    EXPECT_LE(less.error, max_error);
    EXPECT_NEAR(mass_of(left), mass_of(bank), 1e-9 * mass_of(bank));
    const double found = depth_error(bank, left, 400);
    EXPECT_LT(found, 1.5 * less.error + 1e-3);
    EXPECT_GT(found, 0.4 * less.error);
  }
  EXPECT_LT(last, 800u);
}

// Coincident ones cost nothing; those that stand alone are seen as they are.
TEST(Simplify, KeepsWhatStandsAlone) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 8; ++i) gaussians.push_back({{10.0 * i, 0.0, 0.0}, 1.0, 0.5});
  const Simplified same = *simplify(medium_of(gaussians), {0.1});
  EXPECT_TRUE(same.merged.empty());
  EXPECT_EQ(same.of(medium_of(gaussians)), gaussians);
  gaussians.push_back({{0.0, 0.0, 0.0}, 1.0, 0.25});
  const Simplified less = *simplify(medium_of(gaussians), {1e-3});
  EXPECT_EQ(less.kept, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7}));
  ASSERT_EQ(less.merged.size(), 1u);
  EXPECT_NEAR(less.merged[0].density, 0.75, 1e-12);
  EXPECT_NEAR(less.error, 0.0, 1e-6);
}

TEST(Simplify, MergesOnlyWhatIsAlike) {
  Gaussian plain{{0, 0, 0}, 1.0, 0.5};
  Gaussian grouped = plain;
  grouped.group = 3;
  Gaussian glowing = plain;
  glowing.optics.emission = {1, 0, 0};
  Gaussian dark = plain;
  dark.optics.albedo = glm::dvec3(0.5);
  for (const Gaussian& other : {grouped, glowing, dark}) {
    EXPECT_EQ(simplify(medium_of({plain, other}), {1.0})->kept.size(), 2u);
    const Simplified same = *simplify(medium_of({other, other}), {0.01});
    ASSERT_EQ(same.merged.size(), 1u);
    EXPECT_EQ(same.merged[0].optics, other.optics);
    EXPECT_EQ(same.merged[0].group, other.group);
  }
  const Simplified across = *simplify(medium_of({plain, grouped}), {0.01, true});
  ASSERT_EQ(across.merged.size(), 1u);
  EXPECT_EQ(across.merged[0].group, 0u);
}

TEST(Simplify, NothingOfNothing) {
  EXPECT_TRUE(simplify({}, {0.1})->of({}).empty());
  std::vector<Gaussian> empty(5, Gaussian{{1, 2, 3}, 0.5, 0.0});
  const Simplified less = *simplify(medium_of(empty), {0.1});
  EXPECT_EQ(mass_of(less.of(medium_of(empty))), 0.0);
  EXPECT_EQ(less.error, 0.0);
  // Far apart, and of sizes that differ much.
  const std::vector<Gaussian> far{
      {{-1e9, 0, 0}, 1e-6, 1.0}, {{1e9, 0, 0}, 1e6, 1e-6}, {{0, 0, 0}, 1, 1}};
  for (const Gaussian& g : simplify(medium_of(far), {0.5})->of(medium_of(far))) {
    EXPECT_TRUE(std::isfinite(g.radius) && std::isfinite(g.density) && g.radius > 0.0);
  }
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(simplify(medium_of(empty), {0.1}, stop.get_token()));
}

// simplify() to ellipsoids, and of ellipsoids.

glm::dquat random_turn(Random& random) {
  const glm::dvec3 axis = glm::normalize(random.point(1.0) + 1e-3);
  return glm::angleAxis(random.uniform(0.0, 3.0), axis);
}

Gaussian random_ellipsoid(Random& random, double min_stretch) {
  Gaussian g;
  g.center = random.point(1.0);
  g.density = random.uniform(0.5, 1.5);
  g.set_radii({random.uniform(0.2, 1.0), random.uniform(0.2, 1.0), min_stretch},
              random_turn(random));
  return g;
}

// Small balls that overlap, along lines and on sheets of all directions.
std::vector<Gaussian> strands_and_sheets(std::size_t count, double depth) {
  Random random(11);
  std::vector<Gaussian> gaussians;
  double mass = 0.0;
  while (gaussians.size() < count) {
    const glm::dquat turn = random_turn(random);
    const glm::dvec3 center = random.point(0.6);
    const bool is_sheet = random.uniform(0.0, 1.0) < 0.5;
    for (int i = 0; i < 300; ++i) {
      Gaussian& g = gaussians.emplace_back();
      const glm::dvec3 flat(random.uniform(-0.4, 0.4), is_sheet ? random.uniform(-0.4, 0.4) : 0.0,
                            0.0);
      g.center = center + turn * (flat + random.point(0.01));
      g.radius = is_sheet ? 0.08 : 0.04;
      g.density = random.uniform(0.5, 1.5);
      mass += std::pow(std::numbers::pi, 1.5) * g.density * std::pow(g.radius, 3);
    }
  }
  for (Gaussian& g : gaussians) g.density *= depth * 4.0 / mass;
  return gaussians;
}

double greatest_difference(const glm::dmat3& a, const glm::dmat3& b) {
  double greatest = 0.0;
  for (int k = 0; k < 3; ++k) greatest = std::max(greatest, glm::length(a[k] - b[k]));
  return greatest;
}

TEST(GaussianMoments, AreThoseOfTheGaussian) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Gaussian g = random_ellipsoid(random, random.power(-3.5, 0.0));
    const GaussianMoments moments(g);
    Gaussian back;
    moments.apply_to(back);
    EXPECT_NEAR(back.radius, g.radius, 1e-7 * g.radius);
    EXPECT_NEAR(back.mean_radius(), g.mean_radius(), 1e-7 * g.mean_radius());
    EXPECT_NEAR(back.density, g.density, 1e-6 * g.density);
    const GaussianMoments again(back);
    EXPECT_NEAR(again.mass, moments.mass, 1e-12 * moments.mass);
    EXPECT_LT(greatest_difference(again.covariance, moments.covariance), 1e-12);
  }
  Gaussian ball;
  GaussianMoments(Gaussian{{1, 2, 3}, 0.3, 2.0}).apply_to(ball);
  EXPECT_TRUE(ball.is_ball());
  EXPECT_NEAR(ball.radius, 0.3, 1e-15);
  EXPECT_NEAR(ball.density, 2.0, 1e-14);
}

// Against the definition: twice the average depth of a Gaussian of both covariances.
TEST(GaussianMoments, SquaredErrorIsAsDefined) {
  Random random(4);
  const auto product = [](const GaussianMoments& a, const GaussianMoments& b) {
    GaussianMoments sum = a;
    sum.mass = 1.0;
    sum.center = b.center - a.center;
    sum.covariance = a.covariance + b.covariance;
    Gaussian gaussian;
    sum.apply_to(gaussian);
    const StandaloneTerm term(gaussian);
    return 2.0 * a.mass * b.mass * average_depth(*term, glm::dvec3(0.0));
  };
  for (int i = 0; i < 200; ++i) {
    const GaussianMoments a(random_ellipsoid(random, random.power(-2.0, 0.0)));
    const GaussianMoments b(random_ellipsoid(random, random.power(-2.0, 0.0)));
    GaussianMoments one(a, b);
    if (i % 2 == 0) one.make_round();
    const double expected = product(a, a) + product(b, b) + product(one, one) +
                            2.0 * (product(a, b) - product(a, one) - product(b, one));
    EXPECT_NEAR(squared_error(a, b, one), expected, 0.01 * expected) << i;
  }
}

// However thin and slanted: the same error for pairs that differ by a turn of all.
TEST(GaussianMoments, SquaredErrorOfNeedlesAndDiscs) {
  Random random(5);
  for (const double thin : {1e-2, 1e-3, 1e-4}) {
    for (const glm::dvec3& radii : {glm::dvec3(1.0, thin, thin), glm::dvec3(1.0, 1.0, thin)}) {
      const auto error = [&](const glm::dquat& turn) {
        Gaussian a{{}, 1.0, 1.0};
        a.set_radii(radii, turn);
        Gaussian b = a;
        b.center = turn * (0.3 * radii);
        const GaussianMoments first(a);
        const GaussianMoments second(b);
        return squared_error(first, second, GaussianMoments(first, second));
      };
      const double straight = error(glm::dquat(1.0, 0.0, 0.0, 0.0));
      EXPECT_GT(straight, 0.0);
      for (int i = 0; i < 50; ++i) {
        const glm::dvec3 q = random.point(1.0);
        const glm::dquat turn =
            glm::normalize(glm::dquat(random.uniform(-1.0, 1.0), q.x, q.y, q.z));
        EXPECT_NEAR(error(turn), straight, 0.01 * straight) << thin << ' ' << radii.y;
      }
    }
  }
}

TEST(Simplify, EllipsoidsAreFewerWithinTheSameError) {
  const std::vector<Gaussian> bank = strands_and_sheets(6000, 0.8);
  const Medium medium = medium_of(bank);
  for (const double max_error : {0.02, 0.05}) {
    const Simplified balls = *simplify(medium, {max_error});
    const Simplified less = *simplify(medium, {max_error, false, true});
    const std::vector<Gaussian> left = less.of(medium);
    SCOPED_TRACE(testing::Message()
                 << max_error << ": " << balls.of(medium).size() << " balls, " << left.size());
    EXPECT_LT(left.size(), 2 * balls.of(medium).size() / 3);
    EXPECT_LE(less.error, max_error);
    EXPECT_NEAR(mass_of(left), mass_of(bank), 1e-9 * mass_of(bank));
    const double found = depth_error(bank, left, 400);
    EXPECT_LT(found, 1.5 * less.error + 1e-3);
    EXPECT_GT(found, 0.4 * less.error);
  }
}

// Balls and ellipsoids that it simplifies to are judged by their own shapes.
TEST(Simplify, OfEllipsoids) {
  Random random(6);
  std::vector<Gaussian> bank = fog_bank(3000, 0.8, 5);
  for (Gaussian& g : bank) {
    const glm::dvec3 radii = g.radius * glm::dvec3(2.0, 1.0, 0.5);
    g.set_radii(radii, random_turn(random));
  }
  const Medium medium = medium_of(bank);
  for (const bool ellipsoids : {false, true}) {
    const Simplified less = *simplify(medium, {0.05, false, ellipsoids});
    const std::vector<Gaussian> left = less.of(medium);
    SCOPED_TRACE(testing::Message() << ellipsoids << ": " << left.size());
    EXPECT_LT(left.size(), ellipsoids ? 2000u : 3000u);
    EXPECT_LE(less.error, 0.05);
    for (const Gaussian& g : less.merged) EXPECT_TRUE(ellipsoids || g.is_ball());
    EXPECT_NEAR(mass_of(left), mass_of(bank), 1e-9 * mass_of(bank));
    const double found = depth_error(bank, left, 400);
    EXPECT_LT(found, 1.5 * less.error + 1e-3);
    EXPECT_GT(found, 0.4 * less.error);
  }
  // Two long ones in line are one longer; crossed ones are no ball.
  Gaussian along;
  along.density = 1.0;
  along.set_radii({1.0, 0.05, 0.05}, glm::dquat(1, 0, 0, 0));
  Gaussian further = along;
  further.center.x = 0.5;
  Gaussian across = along;
  across.set_radii({0.05, 1.0, 0.05}, glm::dquat(1, 0, 0, 0));
  EXPECT_EQ(simplify(medium_of({along, further}), {0.03, false, true})->merged.size(), 1u);
  EXPECT_TRUE(simplify(medium_of({along, across}), {0.3})->merged.empty());
}

TEST(Simplify, EllipsoidsOfNothing) {
  const SimplifyLimits limits{0.5, false, true};
  EXPECT_TRUE(simplify({}, limits)->of({}).empty());
  const std::vector<Gaussian> empty(5, Gaussian{{1, 2, 3}, 0.5, 0.0});
  EXPECT_EQ(mass_of(simplify(medium_of(empty), limits)->of(medium_of(empty))), 0.0);
  // Far apart, and of sizes that differ much; in line.
  std::vector<Gaussian> far{
      {{-1e9, 0, 0}, 1e-6, 1.0}, {{1e9, 0, 0}, 1e6, 1e-6}, {{0, 0, 0}, 1, 1}, {{1e6, 0, 0}, 1, 1}};
  for (const double error : {0.1, 1.0}) {
    for (const Gaussian& g : simplify(medium_of(far), {error, false, true})->of(medium_of(far))) {
      EXPECT_TRUE(std::isfinite(g.radius) && std::isfinite(g.density) && g.radius > 0.0);
      EXPECT_TRUE(std::isfinite(glm::length(g.shape.rotation)));
    }
  }
}

}  // namespace

}  // namespace brume
