#include <gtest/gtest.h>

#include <algorithm>

#include "tests/render/test_scenes.h"

namespace brume {
namespace {

struct MarchedScene {
  const char* name;
  Scene scene;
  double fine;  // bound of the relative RMSE with 1024 steps, about twice what is measured
};

// The part that may be left out of each depth costs about this much.
constexpr double culling_error = 2e-4;

Scene clump() {
  Scene scene = on_film(cloud_scene(30, 3.0), {16, 16});
  return scene;
}

Scene clump_behind_wall() {
  Scene scene = clump();
  scene.lights[0].position = {0.2, 0.1, -4.0};
  scene.surfaces.push_back(wall(-2.0, 0.4));
  return scene;
}

Scene light_inside() {
  Scene scene = clump();
  scene.lights[0].position = {0.2, 0.1, 0.3};
  scene.lights.push_back({{-3, 2, 1}, {1, 5, 9}, {}});
  return scene;
}

Scene scattering_and_absorbing() {
  Scene scene = in_fog(clump(), 0.05);
  scene.optics.anisotropy = 0.6;
  scene.optics.albedo = {0.4, 0.7, 0.7};
  scene.surfaces.push_back(wall(0.05, 3.0));
  return scene;
}

std::vector<MarchedScene> rows() {
  return {
      {"clump", clump(), 3e-4},
      {"fog alone", in_fog(cloud_scene(1, 1e-12), 0.1), 1e-4},
      {"shaft", clump_behind_wall(), 2e-3},
      {"light inside", light_inside(), 1e-4},
      {"scattering and absorbing", scattering_and_absorbing(), 1e-4},
  };
}

TEST(March, ConvergesToTheReference) {
  for (const MarchedScene& row : rows()) {
    SCOPED_TRACE(row.name);
    const Frame reference = render_frame(row.scene, reference_settings(1e-4));
    double last = 1e9;
    for (const int steps : {4, 16, 64, 256, 1024}) {
      const Frame frame = render_frame(row.scene, marched(steps));
      const double error = rel_rmse(frame.airlight, reference.airlight);
      EXPECT_LT(error, std::max(0.5 * last, culling_error)) << steps;
      last = error;
      for (std::size_t i = 0; i < frame.transmittance.size(); ++i) {
        ASSERT_NEAR(frame.transmittance[i], reference.transmittance[i], 1e-3);
      }
    }
    EXPECT_LT(last, row.fine);
  }
}

// Where nothing emits light there is still what the medium takes away.
TEST(March, WithoutLightsIsDarkAndDims) {
  Scene scene = clump();
  scene.lights.clear();
  const Frame frame = render_frame(scene, marched(4));
  const Frame paper = render_frame(scene, paper_settings);
  for (const float x : frame.airlight) ASSERT_EQ(x, 0.0f);
  EXPECT_LT(rel_rmse(frame.transmittance, paper.transmittance), 1e-5);
}

}  // namespace
}  // namespace brume
