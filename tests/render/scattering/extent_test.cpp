// Gaussians that are far and thin change nothing: grids and tables are as fine as others need.

#include <gtest/gtest.h>

#include "tests/render/test_scenes.h"

namespace brume {
namespace {

void expect_unchanged_by_far_gaussian(Scene scene, const char* name) {
  scene.film = {16, 12};
  const Settings settings = sliced(Settings{}.slices, Scattering::multiple);
  const Frame alone = render_frame(scene, settings);
  scene.medium.append({{-3.0, 9.0, 260.0}, 0.85, 0.0013});  // of optical depth 0.002
  EXPECT_LT(rel_rmse(render_frame(scene, settings).beauty, alone.beauty), 1e-3) << name;
}

TEST(FarThinGaussians, ChangeNothing) {
  Scene under_sky = cloud_scene(30, 2.0);
  under_sky.environment = even_sky(1.0f);
  expect_unchanged_by_far_gaussian(under_sky, "under a sky");
  under_sky.medium.set_homogeneous_density(0.01);
  expect_unchanged_by_far_gaussian(under_sky, "in fog under a sky");
  expect_unchanged_by_far_gaussian(cut_by_a_surface(), "with a wall");
}

}  // namespace
}  // namespace brume
