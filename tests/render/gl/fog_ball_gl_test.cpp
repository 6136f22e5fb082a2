// Homogeneous fog in a ball, `medium.extent`, on OpenGL.

#include <gtest/gtest.h>

#include "tests/render/fog_ball_frames.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

// Seen from outside and from within, with walls before it, in it and behind it.
TEST_F(GlFrames, FogInABallLitByASunAndALight) {
  for (const bool is_within : {false, true}) {
    Scene scene = is_within ? fog_ball_scene({0.2, 0.3, 0.5}) : fog_ball_between_walls();
    scene.optics.anisotropy = 0.4;
    scene.lights = {{{1.5, 2.0, 0.5}, {10, 10, 10}, {}}, {{}, {6, 6, 6}, {}}};
    scene.lights[1].kind = light::Directional{{-0.9, -1.4, -0.6}};
    expect_backends_agree(scene, Scattering::single);
    expect_backends_agree(scene, Scattering::multiple);
    const Frame frame = render_on_device(scene, quick_slices(), "ball");
    EXPECT_LT(fog_transmittance_error(scene, frame), 1e-4) << is_within;
    if (is_within) {
      EXPECT_LT(scattered_once_error(scene, frame), 0.01);
    }
  }
}

TEST_F(GlFrames, FogInABallByThePaper) {
  Scene scene = fog_ball_scene();
  scene.lights = {{{1.5, 2.0, 0.5}, {10, 10, 10}, {}}, {{0.2, 0.4, -0.3}, {5, 5, 5}, {}}};
  const Frame frame = render_on_device(scene, paper_settings, "paper");
  EXPECT_LT(scattered_once_error(scene, frame), 0.003);
  EXPECT_LT(fog_transmittance_error(scene, frame), 1e-4);
}

// Among Gaussians under a sky, whose light on surfaces goes through the average depth or the grid.
TEST_F(GlFrames, FogInABallUnderASky) {
  Scene scene = in_fog(on_film(cloud_scene(10, 0.5), {32, 24}), 0.5);
  scene.optics.extent = 1.2;
  scene.optics.anisotropy = 0.6;
  scene.surfaces = {wall(-1.0, 0.5)};
  scene.environment.emplace();
  scene.environment->map = constant_sky(1.0f);
  expect_backends_agree(scene, Scattering::single);
  expect_backends_agree(scene, Scattering::multiple);
  const Frame cpu = render_frame(scene, paper_settings);
  const Frame gl = render_on_device(scene, paper_settings, "paper");
  EXPECT_LE(rel_rmse(gl.beauty, cpu.beauty), 2e-3);
}

}  // namespace
}  // namespace brume::gl
