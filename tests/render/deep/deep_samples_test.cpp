#include "render/deep/deep_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brume {
namespace {

// A ray through Gaussians of optical depth `depth` each, centers 1 u apart, lit with radiance
// 1, 2, 3 times exp(-t): `points` at equal distances from 0 to 4.
RayProfile gaussians(double depth, int count, int points, const glm::dvec3& channels) {
  RayProfile ray;
  glm::dvec3 light(0.0);
  glm::dvec3 last(0.0);
  for (int i = 0; i < points; ++i) {
    const double t = 4.0 * i / (points - 1);
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {
      sum += 0.5 * depth * (std::erf((t - 1.0 - k) / 0.3) - std::erf((-1.0 - k) / 0.3));
    }
    const glm::dvec3 depths = channels * sum;
    const double middle = t - 2.0 / (points - 1);
    for (int c = 0; c < 3; ++c) {
      light[c] += (std::exp(-last[c]) - std::exp(-depths[c])) * (1.0 + c) * std::exp(-middle);
    }
    last = depths;
    ray.add(static_cast<float>(t), depths, light);
  }
  return ray;
}

DeepTolerance tolerance_of(double error, const RayProfile& ray) {
  return {error, error * ray.airlight.back()};
}

// The largest error at a point, in tolerances.
double worst(const RayProfile& ray, const DeepTolerance& tolerance,
             const std::vector<DeepSample>& samples) {
  double worst = 0.0;
  for (std::size_t i = 0; i < ray.size(); ++i) {
    const HeldOut seen =
        held_out(samples.data(), samples.size(), static_cast<double>(ray.distances[i]));
    for (int c = 0; c < 3; ++c) {
      worst = std::max(
          {worst,
           std::abs(seen.transmittance[c] - ray.transmittance[i][c]) / tolerance.transmittance,
           std::abs(seen.airlight[c] - ray.airlight[i][c]) / tolerance.airlight[c]});
    }
  }
  return worst;
}

// The fewest samples that keep the tolerance: over all ways to cut the ray at its points.
std::size_t fewest(const RayProfile& ray, const DeepTolerance& tolerance) {
  std::vector<std::size_t> count(ray.size(), std::numeric_limits<std::size_t>::max());
  count[0] = 0;
  for (std::size_t b = 1; b < ray.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      RayProfile part;
      for (std::size_t i = a; i <= b; ++i) {
        part.add(ray.distances[i], ray.depths[i] - ray.depths[a],
                 (ray.airlight[i] - ray.airlight[a]) / ray.transmittance[a]);
      }
      std::vector<DeepSample> one;
      fit_deep_samples(part, {1e9, glm::dvec3(1e9)}, one);
      const DeepTolerance scaled{tolerance.transmittance / ray.transmittance[a].x,
                                 tolerance.airlight / ray.transmittance[a].x};
      if (worst(part, scaled, one) <= 1.0 + 1e-6) {
        count[b] = std::min(count[b], count[a] + one.size());
      }
    }
  }
  return count.back();
}

TEST(DeepSamples, OneSampleIsHomogeneousFog) {
  RayProfile ray;
  for (int i = 0; i <= 20; ++i) {
    const double t = 0.1 * i;
    ray.add(static_cast<float>(1.0 + t), glm::dvec3(2.0 * t), glm::dvec3(5.0 * (1 - exp(-2 * t))));
  }
  std::vector<DeepSample> samples;
  fit_deep_samples(ray, {1e-5, glm::dvec3(1e-5)}, samples);
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_FLOAT_EQ(samples[0].z, 1.0f);
  EXPECT_FLOAT_EQ(samples[0].z_back, 3.0f);
  EXPECT_NEAR(samples[0].alpha.g, 1.0 - std::exp(-4.0), 1e-6);
  EXPECT_NEAR(samples[0].color.r, 5.0 * (1.0 - std::exp(-4.0)), 1e-5);
}

TEST(DeepSamples, KeepTheToleranceAndAllOfTheRay) {
  for (const glm::dvec3& channels : {glm::dvec3(1.0), glm::dvec3(1.0, 2.0, 0.3)}) {
    for (const double depth : {0.01, 1.0, 8.0}) {
      for (const double error : {0.1, 0.01, 0.001}) {
        const RayProfile ray = gaussians(depth, 3, 400, channels);
        const DeepTolerance tolerance = tolerance_of(error, ray);
        std::vector<DeepSample> samples;
        fit_deep_samples(ray, tolerance, samples);
        EXPECT_LE(worst(ray, tolerance, samples), 1.0 + 1e-4) << depth << " " << error;
        const HeldOut all = held_out(samples.data(), samples.size(), 1e9);
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(all.airlight[c], ray.airlight.back()[c], 3e-6 * ray.airlight.back()[c]);
          EXPECT_NEAR(all.transmittance[c], ray.transmittance.back()[c], 1e-6);
        }
      }
    }
  }
}

// Ends of samples are exact, so the longest sample each time is the fewest samples, unless a longer
// one fits where a shorter does not.
TEST(DeepSamples, AreFewest) {
  for (const double depth : {0.3, 3.0}) {
    for (const double error : {0.1, 0.01}) {
      const RayProfile ray = gaussians(depth, 3, 41, glm::dvec3(1.0));
      const DeepTolerance tolerance = tolerance_of(error, ray);
      std::vector<DeepSample> samples;
      fit_deep_samples(ray, tolerance, samples);
      EXPECT_LE(samples.size(), fewest(ray, tolerance) + 1) << depth << " " << error;
    }
  }
}

TEST(DeepSamples, LeaveGapsBetweenClouds) {
  RayProfile ray;
  for (const auto& [t, depth] : {std::pair(1.0, 0.0),
                                 {2.0, 0.0},
                                 {3.0, 1.0},
                                 {4.0, 1.0},
                                 {8.0, 1.0},
                                 {9.0, 1.5},
                                 {10.0, 1.5}}) {
    ray.add(static_cast<float>(t), glm::dvec3(depth), glm::dvec3(1.0 - std::exp(-depth)));
  }
  std::vector<DeepSample> samples;
  fit_deep_samples(ray, {1e-3, glm::dvec3(1e-3)}, samples);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].z, 2.0f);
  EXPECT_EQ(samples[0].z_back, 3.0f);
  EXPECT_EQ(samples[1].z, 8.0f);
  EXPECT_EQ(samples[1].z_back, 9.0f);
}

// In float an alpha of nearly 1 is 1, and a volume of it is opaque at its front.
TEST(DeepSamples, StayInsideOpaqueFog) {
  const RayProfile ray = gaussians(200.0, 1, 400, glm::dvec3(1.0));
  const DeepTolerance tolerance = tolerance_of(0.02, ray);
  std::vector<DeepSample> samples;
  fit_deep_samples(ray, tolerance, samples);
  EXPECT_GT(samples.size(), 2u);
  EXPECT_LE(worst(ray, tolerance, samples), 1.0 + 1e-4);
  for (const DeepSample& sample : samples) EXPECT_TRUE(std::isfinite(sample.color.r));
}

TEST(DeepSamples, TellWhatIsBetweenPoints) {
  const double coarse =
      error_between_points(gaussians(2.0, 1, 21, glm::dvec3(1.0)), {0.01, glm::dvec3(0.01)});
  const double fine =
      error_between_points(gaussians(2.0, 1, 41, glm::dvec3(1.0)), {0.01, glm::dvec3(0.01)});
  EXPECT_GT(coarse, 0.5);
  EXPECT_LT(fine, 0.4 * coarse);
}

}  // namespace
}  // namespace brume
