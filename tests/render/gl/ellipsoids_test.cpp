// Ellipsoidal Gaussians, on the device and on the CPU.

#include <gtest/gtest.h>

#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

TEST_F(GlFrames, Ellipsoids) {
  for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
    Scene scene = in_fog(ellipsoid_scene(20, 2.0, 12.0), 0.02);
    scene.film = {32, 24};
    scene.surfaces.push_back(wall(-0.6, 1.2));
    expect_backends_agree(scene, scattering);
  }
}

TEST_F(GlFrames, EllipsoidsByThePaper) {
  for (const bool at_mean : {false, true}) {
    Scene scene = ellipsoid_scene(20, 2.0, 12.0, 2);
    scene.film = {32, 24};
    scene.optics.noise = {.amplitude = 0.4, .frequency = 2.0};
    Settings settings = paper_settings;
    settings.paper.at_mean = at_mean;
    const Frame cpu = on_cpu(scene, settings);
    const Frame gl = render_on_device(scene, settings, "paper");
    EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 1e-3);
  }
}

// The eye and the light among needles and discs.
TEST_F(GlFrames, EllipsoidsAllAround) {
  Scene scene = ellipsoid_scene(16, 2.0, 200.0, 3);
  scene.film = {32, 24};
  scene.camera.eye = {0.2, 0.1, 0.6};
  scene.lights[0].position = {-0.3, 0.2, -0.4};
  // Needles of less than a pixel differ by the rounding of single precision.
  Settings settings = quick_slices();
  const Frame cpu = on_cpu(scene, settings);
  const Frame gl = render_on_device(scene, settings, "among them");
  EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 1e-2);
}

}  // namespace
}  // namespace brume::gl
