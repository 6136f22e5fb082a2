#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/math/sphere_rule.h"
#include "render/geometry/fog_ball.h"
#include "tests/random.h"

namespace brume {
namespace {

TEST(FogBall, IntervalsAreWhereRaysAreInIt) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const FogBall ball{random.point(2.0), random.uniform(0.5, 3.0)};
    const glm::dvec3 x = random.point(5.0);
    const glm::dvec3 w = glm::normalize(random.point(1.0));
    const double distance = random.uniform(0.0, 10.0);
    double length = 0.0;
    double first = 0.0;
    constexpr int steps = 20000;
    constexpr double step = 20.0 / steps;
    const FogInterval interval = ball.interval(x, w);
    double in_interval = 0.0;
    for (int k = 0; k < steps; ++k) {
      const double t = step * (k + 0.5);
      if (interval.contains(t)) in_interval += step;
      if (!ball.contains(x + t * w)) continue;
      length += step;
      if (t < distance) first += step;
    }
    EXPECT_NEAR(in_interval, length, 2.0 * step);
    EXPECT_NEAR(interval.end - interval.begin, length, 2.0 * step);
    EXPECT_NEAR(ball.length(x, w), length, 2.0 * step);
    EXPECT_NEAR(ball.length(x, w, distance), first, 2.0 * step);
    EXPECT_NEAR(interval.before(distance), first, 2.0 * step);
  }
}

TEST(FogBall, EndlessFogIsAllTheWay) {
  const FogBall everywhere;
  const glm::dvec3 x(1.0, 2.0, 3.0);
  const glm::dvec3 w(0.0, 1.0, 0.0);
  EXPECT_EQ(everywhere.length(x, w, 5.0), 5.0);
  EXPECT_EQ(everywhere.length(x, w), infinity);
  EXPECT_EQ(everywhere.interval(x, w).before(7.0), 7.0);
  EXPECT_TRUE(everywhere.contains(x));
}

// Nothing is lost next to the middle of a ball of a million units.
TEST(FogBall, LargeBallsKeepShortWays) {
  const FogBall ball{{1.0, 0.0, 0.0}, 1e6};
  const glm::dvec3 w = glm::normalize(glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(ball.length({0.5, 0.25, 0.0}, w, 0.125), 0.125);
  EXPECT_NEAR(ball.length({0.5, 0.25, 0.0}, w), 1e6, 2.0);
}

TEST(FogBall, MeanLengthIsThatOverDirections) {
  const FogBall ball{{0.5, -1.0, 2.0}, 1.5};
  for (const double s : {0.0, 1e-5, 0.01, 0.5, 0.99, 1.01, 2.0, 10.0}) {
    const glm::dvec3 x = ball.center + s * ball.radius * glm::dvec3(0.0, 0.0, 1.0);
    double sum = 0.0;
    constexpr int steps = 200000;
    for (int k = 0; k < steps; ++k) {  // over the cosine from the axis
      const double cosine = -1.0 + 2.0 * (k + 0.5) / steps;
      sum += ball.length(x, {std::sqrt(1.0 - cosine * cosine), 0.0, cosine}) / steps;
    }
    EXPECT_NEAR(ball.mean_length(x), sum, 1e-4) << s;
  }
}

}  // namespace
}  // namespace brume
