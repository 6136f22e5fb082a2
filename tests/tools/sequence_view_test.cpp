// Sequences of volumes, fitted, as they are seen.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/fit/volume_fitter.h"
#include "tools/fit_report/sequence_view.h"

namespace brume {
namespace {

const std::filesystem::path volumes = BRUME_VOLUMES;

std::vector<float> difference(std::span<const float> a, std::span<const float> b) {
  std::vector<float> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

// A picture of the Gaussians changes from frame to frame as much as one of the smoke itself, within
// the 10% that the project promises; and what it changes otherwise than the smoke, which is seen as
// flicker, is less than where each frame is fitted by itself.
TEST(SequenceView, FittedSmokeDoesNotFlicker) {
  VolumeFit how;
  how.options.count = 60;
  VolumeFitter fitter(how);
  const FittedVolume first = *fitter.next(volumes / "smoke_0025.vdb");
  const FittedVolume second = *fitter.next(volumes / "smoke_0026.vdb");
  const FittedVolume by_itself = *VolumeFitter(how).next(volumes / "smoke_0026.vdb");
  const SequenceView view(first.grid, Film{32, 32});
  const std::vector<float> before = view.render(first.fit.gaussians);
  const std::vector<float> smoke = difference(view.render(second.grid), view.render(first.grid));
  const std::vector<float> fog = difference(view.render(second.fit.gaussians), before);
  const std::vector<float> anew = difference(view.render(by_itself.fit.gaussians), before);
  const std::vector<float> nothing(smoke.size());
  EXPECT_NEAR(std::sqrt(squares_between(fog, nothing) / squares_between(smoke, nothing)), 1.0, 0.1);
  const double flicker = std::sqrt(squares_between(fog, smoke));
  EXPECT_LT(flicker, 0.9 * std::sqrt(squares_between(anew, smoke)));
}

}  // namespace
}  // namespace brume
