// `brume bench` reports errors of fog besides its speed.

#include "tools/bench/errors/fog_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/bench/errors/noise_errors.h"

namespace brume {
namespace {

TEST(FogErrors, InscatteringIsExactInThinFogOnly) {
  const std::vector<InscatteringRow> rows = measure_inscattering();
  ASSERT_FALSE(rows.empty());
  for (const InscatteringRow& row : rows) {
    // T e^-T over 1 - e^-T, which is what leaves the eye's side; in the middle of the Gaussian the
    // sky is dimmed on its way there, so single scattering gives less than that.
    EXPECT_GT(row.share, row.depth / std::expm1(row.depth)) << row.depth;
    EXPECT_LT(row.share, 1.0) << row.depth;
  }
}

TEST(FogErrors, FewerPixelsChangeLittle) {
  const std::vector<ScaleRow> rows = measure_scales();
  ASSERT_FALSE(rows.empty());
  for (const ScaleRow& row : rows) {
    const double samples = 1.0 / (row.scale * row.scale);
    EXPECT_GT(row.computed, samples) << row.scene;
    EXPECT_LT(row.computed, 2.0 * samples) << row.scene;
    EXPECT_GT(row.change, 0.0) << row.scene;
    EXPECT_LT(row.change, 0.01) << row.scene;
  }
}

// See Noise.ChangesThePictureButNotTheMeanDepth; from near what comes closer looks larger.
TEST(NoiseErrors, PreserveTheMeanOpticalDepth) {
  for (const NoiseDepthRow& row : measure_noise_depths()) {
    EXPECT_LT(row.afar.min, row.afar.max);
    EXPECT_LT(std::max(-row.afar.min, row.afar.max), 0.04) << row.cells;
    EXPECT_LT(std::max(-row.near.min, row.near.max), 0.1) << row.cells;
  }
}

TEST(NoiseErrors, MatchTheFogWithoutNoise) {
  for (const ComparedError& row : measure_noise_errors(60)) {
    EXPECT_LT(row.error.rel_rmse, 1.25 * row.other->rel_rmse) << row.label;
    EXPECT_NE(row.error.rel_rmse, row.other->rel_rmse) << row.label;
  }
}

}  // namespace
}  // namespace brume
