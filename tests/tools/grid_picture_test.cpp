#include "tools/fit_report/grid_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/volume/medium_grid.h"
#include "render/renderer.h"
#include "tests/random.h"

namespace brume {
namespace {

// A volume looks like the Gaussians that it was sampled from.
TEST(GridPicture, MatchesTheMedium) {
  Random random(1);
  Scene scene;
  for (int i = 0; i < 20; ++i) {
    scene.medium.append({random.point(1.0), random.uniform(0.3, 0.5), random.uniform(0.5, 2.0)});
  }
  scene.camera.eye = {0.5, 1.0, 5.0};
  scene.lights.push_back({{2.0, 3.0, 1.0}, {10.0, 10.0, 10.0}, {}});
  const Film film{24, 18};
  const DensityGrid grid = *MediumSampling::plan(scene.medium, 0.05, 1'000'000)->sample();
  const std::vector<float> picture = grid_picture(grid, scene.camera, film, scene.lights[0]);

  Settings settings;
  settings.airlight = AirlightMethod::reference;
  const Frame frame = *Renderer().render(scene, scene.camera, film, settings);
  double wrong = 0.0;
  double right = 0.0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const double expected = frame.airlight[3 * i];
    wrong += std::pow(static_cast<double>(picture[i]) - expected, 2.0);
    right += expected * expected;
  }
  // Linear between voxels a sixth of a radius apart: some 1% of a peak.
  EXPECT_LT(std::sqrt(wrong / right), 0.01);
  EXPECT_GT(right, 0.0);
}

}  // namespace
}  // namespace brume
