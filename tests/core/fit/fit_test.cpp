// Gaussians fitted to grids, and media sampled on grids.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "brume/fit.h"
#include "core/fit/fit_error.h"
#include "core/fit/fit_problem.h"
#include "core/fit/fit_start.h"
#include "core/io/volume/volume_file.h"
#include "core/volume/medium_grid.h"
#include "tests/random.h"

namespace brume {
namespace {

const std::filesystem::path volumes = BRUME_VOLUMES;

Medium some_medium(int count, std::uint32_t seed) {
  Random random(seed);
  Medium medium;
  for (int i = 0; i < count; ++i) {
    medium.append({random.point(1.0), random.uniform(0.15, 0.4), random.uniform(0.2, 2.0)});
  }
  return medium;
}

DensityGrid sampled(const Medium& medium, double voxel_size) {
  return *MediumSampling::plan(medium, voxel_size, 1'000'000)->sample();
}

double density(const Medium& medium, const glm::dvec3& x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const Gaussian g = medium.gaussian(i);
    const glm::dvec3 d = (x - g.center) / g.radius;
    sum += g.density * std::exp(-glm::dot(d, d));
  }
  return sum;
}

TEST(MediumGrid, StoresTheDensityAtItsVoxels) {
  const Medium medium = some_medium(20, 1);
  const DensityGrid grid = sampled(medium, 0.05);
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 x = glm::round(random.point(2.0) / 0.05) * 0.05;
    // Each Gaussian is left out where it is below 1e-4 of its peak.
    EXPECT_NEAR(grid.at(grid.to_voxel(x)), density(medium, x), 20 * 2.0 * 1e-4 * 0.2 + 1e-6);
  }
  double integral = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    integral +=
        medium.densities()[i] * std::pow(std::sqrt(std::numbers::pi) * medium.radii()[i], 3.0);
  }
  EXPECT_NEAR(grid.integral() / integral, 1.0, 1e-3);
}

TEST(MediumGrid, IsSparseAndLimited) {
  Medium medium;
  medium.append({{0, 0, 0}, 0.1, 1.0});
  medium.append({{1000, 0, 0}, 0.1, 1.0});
  EXPECT_LT(MediumSampling::plan(medium, 0.05, 1000)->blocks(), 40u);
  EXPECT_FALSE(MediumSampling::plan(medium, 0.05, 10));
  EXPECT_FALSE(MediumSampling::plan(medium, 1e-6, 1'000'000)) << "too fine to count";
  EXPECT_EQ(MediumSampling::plan(Medium(), 0.05, 10)->blocks(), 0u);
}

TEST(DensityGrid, CoarserKeepsTheMassWhereItIs) {
  const Medium medium = some_medium(5, 3);
  const DensityGrid fine = sampled(medium, 0.05);
  const DensityGrid coarse = coarser(fine);
  EXPECT_NEAR(coarse.integral() / fine.integral(), 1.0, 1e-5);
  EXPECT_LT(coarse.blocks.size(), fine.blocks.size() / 3);
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 x = random.point(1.0);
    EXPECT_NEAR(coarse.at(coarse.to_voxel(x)), fine.at(fine.to_voxel(x)), 0.25);
  }
}

// J and its transpose against finite differences and each other.
class FitDerivatives : public testing::TestWithParam<FitShape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, FitDerivatives,
                         testing::Values(FitShape::ball, FitShape::ellipsoid));

TEST_P(FitDerivatives, AreRight) {
  const bool is_ball = GetParam() == FitShape::ball;
  DensityGrid grid = sampled(some_medium(4, 5), 0.1);
  if (!is_ball) grid.spacing = {0.1, -0.1, 0.1};  // it may be mirrored
  FitProblem problem(grid, GetParam());
  Random random(6);
  std::vector<FitGaussian> gaussians;
  for (int i = 0; i < 3; ++i) {
    FitGaussian& g = gaussians.emplace_back();
    g.b = random.point(0.8);
    g.a = random.uniform(2.0, 5.0);
    g.c = random.uniform(0.3, 2.0);
    if (is_ball) continue;
    for (int k = 0; k < 3; ++k) g.shape[k] += random.point(0.3);
    const double scale = std::cbrt(glm::determinant(g.shape));
    g.a *= scale;
    g.shape /= scale;
  }
  problem.set(gaussians);
  std::vector<float> before(problem.size());
  problem.residuals(before);
  const std::size_t numbers = is_ball ? 5 : 10;
  std::vector<FitStep> step(3);
  for (FitStep& s : step) {
    for (std::size_t k = 0; k < numbers; ++k) s[k] = random.uniform(-1.0, 1.0);
  }
  std::vector<float> along(problem.size());
  problem.apply(step, along);

  std::vector<float> weights(problem.size());
  for (float& w : weights) w = static_cast<float>(random.uniform(-1.0, 1.0));
  std::vector<FitStep> gathered(3);
  problem.apply_transposed(weights, gathered);
  double left = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    left += static_cast<double>(weights[i] * along[i]);
    scale += std::abs(static_cast<double>(weights[i] * along[i]));
  }
  double right = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < numbers; ++k) right += gathered[i][k] * step[i][k];
  }
  EXPECT_NEAR(left, right, 1e-5 * scale);

  const double h = 1e-3;
  std::vector<FitGaussian> after_step;
  for (std::size_t i = 0; i < 3; ++i) {
    FitStep small = step[i];
    for (double& number : small) number *= h;
    after_step.push_back(moved(gaussians[i], small, GetParam()));
  }
  problem.set(after_step);
  std::vector<float> after(problem.size());
  problem.residuals(after);
  for (std::size_t i = 0; i < after.size(); ++i) {
    // Second order in h, and 1e-5 of a peak where a Gaussian is cut off.
    EXPECT_NEAR((after[i] - before[i]) / h, along[i], 0.03) << i;
  }
}

// To the grid's axes and back, and what limits leave of them.
TEST(FitGaussian, KeepsItsShape) {
  DensityGrid grid;
  grid.spacing = {-0.2, 0.2, 0.2};
  grid.rotation = glm::normalize(glm::dquat(1.0, 0.4, -0.3, 0.2));
  grid.origin = {100.0, -50.0, 7.0};
  Gaussian g{{101.0, -49.0, 8.0}, 1.0, 2.0};
  g.set_radii({0.3, 1.2, 0.5}, glm::normalize(glm::dquat(0.3, 0.1, -0.7, 0.2)));
  FitGaussian own = to_fit_gaussians(grid, std::vector{g})[0];
  const auto expect_same = [&](const Gaussian& back) {
    EXPECT_LT(glm::length(back.center - g.center), 1e-12);
    EXPECT_NEAR(back.radius, g.radius, 1e-12);
    const glm::dmat3 difference = warp(back.shape) - warp(g.shape);
    for (int k = 0; k < 3; ++k) EXPECT_LT(glm::length(difference[k]), 1e-12);
  };
  expect_same(to_gaussian(grid, own));
  limit(own, {.min_radius = 0.1});
  expect_same(to_gaussian(grid, own));
  const std::array<bool, 3> narrow = limit(own, {.min_radius = 0.4});
  EXPECT_EQ(std::ranges::count(narrow, true), 1);
  const glm::dvec3 stretch = to_gaussian(grid, own).shape.stretch;
  EXPECT_NEAR(std::min({stretch.x, stretch.y, stretch.z}), 0.4 / 1.2, 1e-12);
  limit(own, {.min_radius = 0.1, .max_radius = 0.7, .low = own.b + 0.5});
  EXPECT_NEAR(to_gaussian(grid, own).radius, 0.7, 1e-12);
  EXPECT_NEAR(glm::length(to_gaussian(grid, own).center - g.center), std::sqrt(0.75), 1e-12);
  g.set_radii({10.0, 0.1, 0.1}, g.shape.rotation);
  own = to_fit_gaussians(grid, std::vector{g})[0];
  limit(own, {.min_radius = 0.1});
  EXPECT_NEAR(to_gaussian(grid, own).shape.stretch.y, 1.0 / max_fitted_elongation, 1e-12);
}

TEST(FitStart, PreservesTheMass) {
  const DensityGrid grid = sampled(some_medium(10, 7), 0.1);
  for (const FitShape shape : {FitShape::ball, FitShape::ellipsoid}) {
    for (const std::size_t count : {1u, 10u, 200u}) {
      const std::vector<FitGaussian> gaussians = split_into_gaussians(grid, count, shape);
      ASSERT_EQ(gaussians.size(), count);
      double integral = 0.0;
      for (const FitGaussian& g : gaussians) integral += g.integral();
      EXPECT_NEAR(integral / grid.integral(), 1.0, 1e-6);
    }
  }
  EXPECT_TRUE(split_into_gaussians(DensityGrid(), 10, FitShape::ball).empty());
}

// A medium, sampled and fitted again, has the same optical depth.
TEST(GaussianFit, RecoversTheMedium) {
  const DensityGrid grid = sampled(some_medium(30, 8), 0.075);
  const Fit fit = *fit_gaussians(grid, {60, 0.0, FitShape::ball});
  EXPECT_EQ(fit.gaussians.size(), 60u);
  EXPECT_LT(fit.density_error, 0.02);
  EXPECT_LT(depth_error(grid, fit.gaussians, 2000), 0.02);
  EXPECT_NEAR(mass_ratio(grid, fit.gaussians), 1.0, 1e-9);
}

// The time of a step follows the voxels: where a few Gaussians have very many of them, few steps
// are at the grid's own resolution, and the fit is about as good.
TEST(GaussianFit, FewGaussiansInManyVoxelsTakeFewSteps) {
  const Medium medium = some_medium(10, 8);
  const Fit fit = *fit_gaussians(sampled(medium, 0.04), {10, 0.0});
  EXPECT_LT(fit.products, 60u);        // three steps
  EXPECT_LT(fit.density_error, 0.08);  // at the grid's own resolution alone 0.04
}

TEST(GaussianFit, FollowsTheTransform) {
  DensityGrid grid = sampled(some_medium(5, 9), 0.1);
  grid.spacing = {-0.2, 0.2, 0.2};
  grid.rotation = glm::normalize(glm::dquat(1.0, 0.4, -0.3, 0.2));
  grid.origin = {100.0, -50.0, 7.0};
  const Fit fit = *fit_gaussians(grid, {20, 0.0});
  EXPECT_LT(depth_error(grid, fit.gaussians, 2000), 0.03);
}

TEST(GaussianFit, UsesNoMoreGaussiansThanTheErrorRequires) {
  const DensityGrid grid = read_volume(volumes / "smoke_0025.vdb", "density");
  const Fit rough = *fit_gaussians(grid, {2000, 0.5});
  const Fit fine = *fit_gaussians(grid, {2000, 0.25});
  EXPECT_LT(rough.density_error, 0.51);  // scaling the mass may add a little
  EXPECT_LT(fine.density_error, 0.26);
  EXPECT_LT(rough.gaussians.size(), fine.gaussians.size());
  EXPECT_LT(fine.gaussians.size(), 500u);
}

// A medium of long and flat ones is found again by as many, but not by balls.
TEST(GaussianFit, RecoversEllipsoids) {
  Random random(13);
  Medium medium;
  for (int i = 0; i < 8; ++i) {
    Gaussian g{random.point(0.8), 1.0, random.uniform(0.5, 2.0)};
    const double flat = i % 2 == 0 ? 0.5 : 0.16;
    g.set_radii({0.5, flat, 0.16},
                glm::normalize(glm::dquat(1.0, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                          random.uniform(-1.0, 1.0))));
    medium.append(g);
  }
  const DensityGrid grid = sampled(medium, 0.1);
  const Fit fit = *fit_gaussians(grid, {16, 0.0});
  const Fit balls = *fit_gaussians(grid, {16, 0.0, FitShape::ball});
  EXPECT_LT(fit.density_error, 0.05);
  EXPECT_GT(balls.density_error, 4.0 * fit.density_error);
  for (const Gaussian& g : balls.gaussians) EXPECT_TRUE(g.is_ball());
  EXPECT_LT(depth_error(grid, fit.gaussians, 2000), 0.03);
  EXPECT_NEAR(mass_ratio(grid, fit.gaussians), 1.0, 1e-9);
}

// No more elongated than the smoke: few near the limit.
TEST(GaussianFit, EllipsoidsHalveTheErrorOfSmoke) {
  const DensityGrid grid = read_volume(volumes / "smoke_0025.vdb", "density");
  const Fit ellipsoids = *fit_gaussians(grid, {60, 0.0});
  const Fit balls = *fit_gaussians(grid, {60, 0.0, FitShape::ball});
  EXPECT_LT(ellipsoids.density_error, 0.6 * balls.density_error);
  EXPECT_LT(depth_error(grid, ellipsoids.gaussians), depth_error(grid, balls.gaussians));
  std::size_t long_ones = 0;
  for (const Gaussian& g : ellipsoids.gaussians) {
    EXPECT_LT(g.radius, 2.0);  // the smoke is 2 wide
    const glm::dvec3& s = g.shape.stretch;
    long_ones += std::min({s.x, s.y, s.z}) < 0.2 ? 1 : 0;
  }
  EXPECT_LT(long_ones, 12u);
}

// The bounds are those that the project promises for 500 Gaussians.
TEST(GaussianFit, SimulatedSmokeWithinItsBounds) {
  const DensityGrid first = read_volume(volumes / "smoke_0025.vdb", "density");
  const DensityGrid second = read_volume(volumes / "smoke_0026.vdb", "density");
  const Fit fit = *fit_gaussians(first, {150, 0.0});
  const Refit next = *refit_gaussians(second, fit.gaussians);
  ASSERT_EQ(next.fit.gaussians.size(), 150u);
  for (const auto& [grid, of] : {std::pair(&first, &fit), std::pair(&second, &next.fit)}) {
    EXPECT_LT(of->density_error, 0.2);
    EXPECT_LT(depth_error(*grid, of->gaussians), 0.06);
    EXPECT_NEAR(mass_ratio(*grid, of->gaussians), 1.0, 0.005);
  }
  // The next frame has little left to do.
  EXPECT_LT(next.fit.products, fit.products * 3 / 4);
  // Gaussians that were not relocated have stayed where they were: no flicker.
  std::size_t renewed = 0;
  std::size_t strayed = 0;
  for (std::size_t i = 0; i < 150; ++i) {
    renewed += next.renewed[i] ? 1 : 0;
    const Gaussian& a = fit.gaussians[i];
    const Gaussian& b = next.fit.gaussians[i];
    strayed += !next.renewed[i] && glm::length(a.center - b.center) > 2.0 * a.radius ? 1 : 0;
  }
  EXPECT_LT(renewed, 30u);
  EXPECT_LT(strayed, 8u);
}

// Turning about the z axis while moving along it.
glm::dvec3 helix_velocity(const glm::dvec3& x) {
  return {-3.0 * x.y, 3.0 * x.x, 1.0};
}

VelocityGrid helix() {
  VelocityGrid velocity;
  for (int k = 0; k < 3; ++k) {
    DensityGrid& grid = velocity.components[static_cast<std::size_t>(k)];
    grid.spacing = glm::dvec3(0.25);
    for (int block = 0; block < 64; ++block) {
      const glm::ivec3 corner = 8 * (glm::ivec3(block / 16, block / 4 % 4, block % 4) - 2);
      grid.blocks.push_back({corner, {}});
      for (int i = 0; i < 512; ++i) {
        const glm::ivec3 voxel = corner + glm::ivec3(i / 64, i / 8 % 8, i % 8);
        grid.blocks.back().values[static_cast<std::size_t>(i)] =
            static_cast<float>(helix_velocity(grid.to_world(glm::dvec3(voxel)))[k]);
      }
    }
  }
  return velocity;
}

Medium turned(const Medium& medium, double seconds) {
  const glm::dquat turn = glm::angleAxis(3.0 * seconds, glm::dvec3(0.0, 0.0, 1.0));
  Medium result;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    Gaussian g = medium.gaussian(i);
    g.center = turn * g.center + glm::dvec3(0.0, 0.0, seconds);
    result.append(g);
  }
  return result;
}

TEST(VelocityGrid, MovesGaussiansAlong) {
  const Medium medium = some_medium(20, 11);
  std::vector<Gaussian> gaussians;
  for (std::size_t i = 0; i < medium.size(); ++i) gaussians.push_back(medium.gaussian(i));
  VelocityGrid velocity = helix();
  const Medium expected = turned(medium, 0.1);
  const glm::dquat turn = glm::normalize(glm::dquat(1.0, 0.3, -0.2, 0.5));
  const std::vector<Gaussian> moved = advected(gaussians, velocity, 0.1);
  rotate(velocity, turn);
  for (Gaussian& g : gaussians) g.center = turn * g.center;
  const std::vector<Gaussian> elsewhere = advected(gaussians, velocity, 0.1);
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    // (3 * 0.1)^5 / 120 of fourth order, and single precision.
    EXPECT_LT(glm::length(moved[i].center - expected.gaussian(i).center), 1e-4);
    EXPECT_LT(glm::length(elsewhere[i].center - turn * expected.gaussian(i).center), 1e-4);
  }
}

// The next frame's fit begins where the velocity says: nearer, and Gaussian i stays the same piece
// of smoke.
TEST(GaussianFit, NextFrameFollowsTheVelocity) {
  Random random(12);
  Medium medium;
  for (int i = 0; i < 25; ++i) {
    medium.append({random.point(1.0), random.uniform(0.3, 0.4), random.uniform(0.2, 2.0)});
  }
  constexpr double seconds = 0.2;  // 0.6 in angle: up to twice a radius
  const DensityGrid second = sampled(turned(medium, seconds), 0.1);
  std::vector<Gaussian> before;
  for (std::size_t i = 0; i < medium.size(); ++i) before.push_back(medium.gaussian(i));
  // The solver's unit may be another: 16 times the time.
  const std::vector<Gaussian> start = next_start(second, before, helix(), 16.0 * seconds);
  const Refit with = *refit_gaussians(second, start);
  const Refit without = *refit_gaussians(second, before);
  EXPECT_LT(depth_error(second, start, 2000), 0.1 * depth_error(second, before, 2000));
  EXPECT_LT(with.fit.density_error, 0.01);
  const Medium exact = turned(medium, seconds);
  const auto kept = [&](const Refit& refit) {
    int count = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Gaussian g = exact.gaussian(i);
      const bool is_there = glm::length(refit.fit.gaussians[i].center - g.center) < 0.1 * g.radius;
      count += !refit.renewed[i] && is_there ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(kept(with), 25);
  EXPECT_LT(kept(without), 10);
}

TEST(GaussianFit, IsDeterministicAndStops) {
  const DensityGrid grid = sampled(some_medium(10, 10), 0.2);
  EXPECT_EQ(fit_gaussians(grid, {20, 0.0})->gaussians, fit_gaussians(grid, {20, 0.0})->gaussians);
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(fit_gaussians(grid, {20, 0.0}, source.get_token()));
  EXPECT_TRUE(fit_gaussians(DensityGrid(), {20, 0.0})->gaussians.empty());
}

}  // namespace
}  // namespace brume
