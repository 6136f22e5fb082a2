#include "tools/bench/errors/unbiased_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/random.h"

namespace brume {
namespace {

// Differences of `error` everywhere from values of 1, as noisy runs have them.
struct Noisy {
  Runs differences, values;
};
Noisy noisy(double error, double noise, unsigned seed) {
  Random random(seed);
  Noisy result;
  for (std::size_t k = 0; k < independent_runs; ++k) {
    for (int i = 0; i < 40; ++i) {
      const glm::dvec3 off = random.point(noise);
      result.values[k].push_back(glm::dvec3(1.0) + off);
      result.differences[k].push_back(glm::dvec3(error) - off);
    }
  }
  return result;
}

TEST(UnbiasedError, ExcludesTheNoise) {
  constexpr double error = 0.02;
  for (const double noise : {0.001, 0.1}) {
    constexpr int trials = 400;
    double squares = 0.0;
    int held = 0;
    for (unsigned seed = 0; seed < trials; ++seed) {
      const Noisy runs = noisy(error, noise, seed);
      const ErrorEstimate found = unbiased_error(runs.differences, runs.values);
      EXPECT_EQ(found.pixels, 40u);
      squares += found.rel_rmse * found.rel_rmse / trials;
      held += found.low <= error && error <= found.high ? 1 : 0;
    }
    // The mean of the squares is right; cutting negative ones off adds a little.
    EXPECT_NEAR(std::sqrt(squares), error, 0.05 * error) << noise;
    // 95%, estimated to 2% by 400 trials.
    EXPECT_GT(held, 0.9 * trials) << noise;
  }
}

TEST(UnbiasedError, IsZeroWithoutError) {
  const Noisy runs = noisy(0.0, 0.1, 3);
  const ErrorEstimate found = unbiased_error(runs.differences, runs.values);
  EXPECT_EQ(found.low, 0.0);
  EXPECT_LT(found.rel_rmse, 0.01) << "each run is off by 6%";
  EXPECT_GT(found.high, 0.0);
}

}  // namespace
}  // namespace brume
