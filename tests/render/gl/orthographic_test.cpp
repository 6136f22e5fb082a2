// Orthographic cameras, on the device and on the CPU.

#include <gtest/gtest.h>

#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

Scene in_parallel(Scene scene) {
  scene.film = {32, 24};
  scene.camera.eye = {1.5, 2.0, 4.0};
  scene.camera.target = {0.1, 0.0, 0.0};
  scene.camera.height = 2.6;
  return scene;
}

TEST_F(GlFrames, InParallel) {
  for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
    for (const double elongation : {1.0, 8.0}) {
      Scene scene = elongation > 1.0 ? ellipsoid_scene(20, 2.0, elongation) : cloud_scene(20, 2.0);
      scene = in_parallel(in_fog(scene, 0.02));
      scene.surfaces.push_back(wall(-0.6, 1.2));
      expect_backends_agree(scene, scattering);
    }
  }
}

// From the plane of the eye on, in the middle of all.
TEST_F(GlFrames, InParallelFromWithin) {
  Scene scene = in_parallel(in_fog(cloud_scene(20, 2.0), 0.02));
  scene.camera.eye = scene.camera.target + 0.05 * (scene.camera.eye - scene.camera.target);
  expect_backends_agree(scene, Scattering::single);
}

TEST_F(GlFrames, InParallelUnderASky) {
  for (const double anisotropy : {0.6, -0.4}) {
    Scene scene = in_parallel(in_fog(cloud_scene(20, 2.0), 0.02));
    scene.surfaces.push_back(wall(-0.6, 1.2));
    scene.environment = even_sky(0.3f);
    scene.optics.anisotropy = anisotropy;
    expect_backends_agree(scene, Scattering::multiple);
  }
}

TEST_F(GlFrames, InParallelByThePaper) {
  for (const bool improved : {false, true}) {
    Scene scene = in_parallel(in_fog(ellipsoid_scene(20, 2.0, 8.0), 0.02));
    scene.optics.noise = {.amplitude = 0.4, .frequency = 2.0};
    Settings settings = paper_settings;
    settings.paper = {improved, improved};
    const Frame cpu = render_frame(scene, settings);
    const Frame gl = render_on_device(scene, settings, "paper");
    EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 1e-3);
  }
}

TEST_F(GlFrames, InParallelWithNoise) {
  Scene scene = in_parallel(in_fog(cloud_scene(20, 2.0), 0.02));
  scene.optics.noise = {.amplitude = 0.4, .frequency = 2.0};
  expect_backends_agree(scene, Scattering::single);
}

}  // namespace
}  // namespace brume::gl
