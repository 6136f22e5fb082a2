// Work and error of a fixed set of frames, so that a change which makes them costlier or worse is
// seen without a clock. Pairs of Gaussians and rays are what frames cost; they are the same on
// every machine but for vectors of other lengths, hence a quarter of slack; so has the error, which
// some pixels tell.

#include <gtest/gtest.h>

#include "render/quality/auto_quality.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

struct MeasuredScene {
  const char* name;
  Scene scene;
  int slices, scale;
  // Measured pairs in millions, and the error.
  double view_pairs, light_pairs, error;
};

TEST(Regression, FramesTakeNoMoreWorkAndAreNoWorse) {
  const MeasuredScene rows[] = {
      {"two Gaussians", two_gaussians(), 24, 1, 0.0506, 0.0273, 0.0012},
      {"cloud of 30", cloud(30, 1.0), 24, 1, 0.213, 0.110, 0.0004},
      {"cloud of 300", cloud(300, 3.0), 24, 4, 0.538, 1.008, 0.0023},
      {"dense cloud of 30", cloud(30, 10.0), 48, 4, 0.175, 0.567, 0.0021},
      {"box of 3,000", box_scene(3000, 2), 24, 4, 0.882, 1.338, 0.013},
  };
  for (MeasuredScene row : rows) {
    row.scene.film = {200, 150};
    Settings settings;
    settings.airlight_scale = row.scale;
    settings = sliced_settings(settings, row.slices);
    const Frame frame = render_frame(row.scene, settings);
    const auto sample = ErrorSample::create(row.scene, row.scene.camera, frame, 60, 1, 1e-3);
    const double error = sample->measure(frame).rel_rmse;
    const double view = 1e-6 * static_cast<double>(frame.statistics.view_pairs);
    const double light = 1e-6 * static_cast<double>(frame.statistics.light_pairs);
    EXPECT_LT(view, 1.25 * row.view_pairs) << row.name;
    EXPECT_LT(light, 1.25 * row.light_pairs) << row.name;
    EXPECT_LT(error, 1.25 * row.error) << row.name;
  }
}

}  // namespace
}  // namespace brume
