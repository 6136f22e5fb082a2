#include "render/samples/pixel_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brume {
namespace {

TEST(PixelFilter, IsADensityOfUnitIntegral) {
  constexpr int steps = 3000;
  double integral = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double x = pixel_filter::width * ((i + 0.5) / steps - 0.5);
    EXPECT_GE(pixel_filter::density(x), 0.0);
    EXPECT_NEAR(pixel_filter::density(x), pixel_filter::density(-x), 1e-12);
    integral += pixel_filter::density(x) * pixel_filter::width / steps;
  }
  EXPECT_NEAR(integral, 1.0, 1e-9);
  EXPECT_EQ(pixel_filter::density(0.76), 0.0);
  EXPECT_LT(pixel_filter::density(0.749), 1e-3);
}

TEST(PixelFilter, SamplesByItsDensity) {
  // The derivative of the inverse of the cumulative distribution is 1 / density.
  for (const double u : {0.01, 0.2, 0.5, 0.7, 0.99}) {
    const double slope = (pixel_filter::sample(u + 1e-6) - pixel_filter::sample(u - 1e-6)) / 2e-6;
    EXPECT_NEAR(slope * pixel_filter::density(pixel_filter::sample(u)), 1.0, 1e-4);
  }
  EXPECT_NEAR(pixel_filter::sample(0.5), 0.0, 1e-12);
}

TEST(PixelSamples, OneIsTheCenter) {
  EXPECT_EQ(pixel_samples(1), std::vector{glm::dvec2(0.0)});
}

// An edge over the left or upper half of a pixel covers half of it, to half a sample.
TEST(PixelSamples, HaveNoPreferredSide) {
  for (const int count : {2, 4, 7, 16, 33, 64}) {
    const std::vector<glm::dvec2> samples = pixel_samples(count);
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(count));
    glm::dvec2 mean(0.0);
    for (const glm::dvec2& s : samples) {
      EXPECT_LE(std::max(std::abs(s.x), std::abs(s.y)), 0.5 * pixel_filter::width);
      mean += s / static_cast<double>(count);
    }
    EXPECT_NEAR(mean.x, 0.0, 1e-12);
    const bool is_power_of_two = (count & (count - 1)) == 0;
    EXPECT_NEAR(mean.y, 0.0, is_power_of_two ? 1e-12 : 0.5 / count);
    const auto left = std::ranges::count_if(samples, [](auto& s) { return s.x < 0.0; });
    const auto above = std::ranges::count_if(samples, [](auto& s) { return s.y < 0.0; });
    EXPECT_LE(std::abs(2 * left - count), 1);
    EXPECT_LE(std::abs(2 * above - count), 2);
  }
}

// The coverage of straight edges of all slopes, against that of many samples.
TEST(PixelSamples, FindTheCoverageOfEdges) {
  const std::vector<glm::dvec2> many = pixel_samples(4096);
  const auto coverage = [](const std::vector<glm::dvec2>& samples, double angle, double distance) {
    const auto inside = std::ranges::count_if(samples, [&](const glm::dvec2& s) {
      return s.x * std::cos(angle) + s.y * std::sin(angle) > distance;
    });
    return static_cast<double>(inside) / static_cast<double>(samples.size());
  };
  const auto rms_error = [&](int count) {
    const std::vector<glm::dvec2> samples = pixel_samples(count);
    double sum = 0.0;
    int edges = 0;
    for (double angle = 0.05; angle < 6.28; angle += 0.1) {
      for (double distance = -0.45; distance < 0.5; distance += 0.1, ++edges) {
        const double error = coverage(samples, angle, distance) - coverage(many, angle, distance);
        sum += error * error;
      }
    }
    return std::sqrt(sum / edges);
  };
  // The measured errors are 0.042 and 0.015; random samples have 0.1 and 0.05.
  EXPECT_LT(rms_error(16), 0.05);
  EXPECT_LT(rms_error(64), 0.02);
}

}  // namespace
}  // namespace brume
