// The Gaussians by which the extent of a medium is measured.

#include "core/math/substantial.h"

#include <gtest/gtest.h>

#include <vector>

namespace brume {
namespace {

GaussianExtent at(double x, double depth) {
  return {{x - 1.0, -1.0, -1.0}, {x + 1.0, 1.0, 1.0}, depth};
}

using Indices = std::vector<std::size_t>;

TEST(SubstantialGaussians, AThinOneFarAwayDoesNotCount) {
  EXPECT_EQ(substantial_gaussians(std::vector{at(0, 1.0), at(100, 0.002), at(1, 0.5)}),
            (Indices{0, 2}));
}

TEST(SubstantialGaussians, ThinOnesCountAmongTheOthers) {
  EXPECT_EQ(substantial_gaussians(std::vector{at(0, 1.0), at(0.5, 0.002)}), (Indices{0, 1}));
}

TEST(SubstantialGaussians, ThinOnesAreThinTogether) {
  std::vector<GaussianExtent> gaussians{at(0, 1.0)};
  for (int i = 0; i < 6; ++i) gaussians.push_back(at(100, 0.002));
  EXPECT_EQ(substantial_gaussians(gaussians).size(), 7u);
}

TEST(SubstantialGaussians, ThinOnesCountIfAllAreThin) {
  EXPECT_EQ(substantial_gaussians(std::vector{at(0, 0.004), at(100, 0.002)}), (Indices{0, 1}));
}

TEST(SubstantialGaussians, ThoseThatEmitCount) {
  std::vector<GaussianExtent> gaussians{at(0, 1.0), at(100, 0.002)};
  gaussians[1].emits = true;
  EXPECT_EQ(substantial_gaussians(gaussians), (Indices{0, 1}));
}

TEST(SubstantialGaussians, NoneAreNone) {
  EXPECT_TRUE(substantial_gaussians({}).empty());
  EXPECT_EQ(substantial_gaussians(std::vector{at(0, 0.0), at(9, 0.0)}), (Indices{0, 1}));
}

}  // namespace
}  // namespace brume
