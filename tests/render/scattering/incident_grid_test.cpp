// Light of an environment incident at surfaces through the medium: on a grid, and as in the paper,
// against unbiased Monte Carlo.

#include "tools/bench/errors/incident_light_errors.h"

#include <gtest/gtest.h>

#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

// Of each run; there are eight.
constexpr std::size_t samples = 125;

// The bounds are what was measured and a third more; up to a half of that is the noise of the Monte
// Carlo.
TEST(NodeRadiance, MatchesTheReferenceInClouds) {
  struct Bounds {
    double grid, average;  // at most, at least
  };
  constexpr Bounds bounds[] = {{0.0035, 0.001}, {0.003, 0.003}, {0.004, 0.0005}, {0.005, 0.015},
                               {0.006, 0.03},   {0.007, 0.007}, {0.026, 0.28},   {0.024, 0.3},
                               {0.015, 0.03},   {0.25, 0.05},   {0.012, 0.015},  {0.012, 0.028},
                               {0.018, 0.7},    {0.04, 0.2}};
  const std::vector<ComparedError> rows = measure_incident_light(samples);
  ASSERT_EQ(rows.size(), std::size(bounds));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_LT(rows[i].error.rel_rmse, bounds[i].grid) << rows[i].label;
    EXPECT_GT(rows[i].other->rel_rmse, bounds[i].average) << rows[i].label;
  }
}

Scene under(std::shared_ptr<const RadianceMap> map, const Medium& medium) {
  Scene scene;
  scene.medium = medium;
  scene.environment.emplace().map = std::move(map);
  return scene;
}

TEST(NodeRadiance, MatchesTheReferenceUnderAGradientSky) {
  const ComparedError inside = incident_light_error(
      "inside", under(smooth_sky(), cloud(30, 2.0).medium), receivers_around({0, 0, 0}), samples);
  EXPECT_LT(inside.error.rel_rmse, 0.02);
  EXPECT_GT(inside.other->rel_rmse, 0.01);
  Medium dense;
  dense.append({{0, 0, 0}, 1.0, 10.0});
  const ComparedError behind =
      incident_light_error("behind", under(smooth_sky(), dense),
                           {{{0, 1.5, 0}, {0, 1, 0}}, {{1.5, 0, 0}, {1, 0, 0}}}, samples);
  EXPECT_LT(behind.error.rel_rmse, 0.015);
  EXPECT_GT(behind.other->rel_rmse, 0.7);
}

TEST(NodeRadiance, ConvergesAsTheGridGrows) {
  const Scene scene = under(uniform_sky(), cloud(30, 10.0).medium);
  constexpr SourceGridSize sizes[] = {{.nodes = 20'000, .directions = 96},
                                      {.nodes = 1'000, .directions = 96}};
  const auto rows = arriving_light_errors("", scene, receivers_around({0, -2, 0}), 250, sizes);
  EXPECT_LT(rows[0].error.rel_rmse, 0.5 * rows[1].error.rel_rmse);
}

}  // namespace
}  // namespace brume
