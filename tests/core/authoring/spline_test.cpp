#include "core/authoring/spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

namespace brume {
namespace {

TEST(Spline, PassesThroughItsPoints) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, 0}};
  const auto samples = sample_spline(points, 0.1);
  EXPECT_EQ(samples.front(), points.front());
  EXPECT_EQ(samples.back(), points.back());
  for (const glm::dvec3& point : points) EXPECT_EQ(std::ranges::count(samples, point), 1);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    EXPECT_LT(glm::distance(samples[k], samples[k - 1]), 0.25);
  }
}

TEST(Spline, OfTwoPointsIsALine) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {2, 0, 0}};
  for (const glm::dvec3& p : sample_spline(points, 0.3)) {
    EXPECT_NEAR(p.y, 0.0, 1e-12);
    EXPECT_NEAR(p.z, 0.0, 1e-12);
  }
}

TEST(Spline, TakesEqualAndFewPoints) {
  EXPECT_TRUE(sample_spline({}, 1.0).empty());
  const std::vector<glm::dvec3> same{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(sample_spline(same, 0.1).size(), 1u);
  const std::vector<glm::dvec3> far{{0, 0, 0}, {1e12, 0, 0}};
  EXPECT_LE(sample_spline(far, 1e-9).size(), 5000u);
}

}  // namespace
}  // namespace brume
