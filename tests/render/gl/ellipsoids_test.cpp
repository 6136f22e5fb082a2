// Ellipsoidal Gaussians, on the device and on the CPU.

#include <gtest/gtest.h>

#include "tests/random.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

TEST_F(GlFrames, Ellipsoids) {
  for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
    Scene scene = on_film(in_fog(ellipsoid_scene(20, 2.0, 12.0), 0.02), {32, 24});
    scene.surfaces.push_back(wall(-0.6, 1.2));
    expect_backends_agree(scene, scattering);
  }
}

// Most memory of a work group is asked for by these.
TEST_F(GlFrames, EllipsoidsWithOpticsOfTheirOwn) {
  Scene scene = on_film(in_fog(ellipsoid_scene(20, 2.0, 12.0, 4), 0.02), {32, 24});
  Medium medium;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    Gaussian g = scene.medium.gaussian(i);
    if (i % 2 == 0) g.optics = {.albedo = glm::dvec3(1.0, 0.5, 0.2), .emission = {1.0, 2.0, 3.0}};
    medium.append(g);
  }
  medium.set_homogeneous_density(scene.medium.homogeneous_density());
  scene.medium = medium;
  expect_backends_agree(scene, Scattering::single);
}

TEST_F(GlFrames, EllipsoidsByThePaper) {
  for (const bool at_mean : {false, true}) {
    Scene scene = on_film(ellipsoid_scene(20, 2.0, 12.0, 2), {32, 24});
    scene.optics.noise = {.amplitude = 0.4, .frequency = 2.0};
    Settings settings = paper_settings;
    settings.paper.at_mean = at_mean;
    const Frame cpu = render_frame(scene, settings);
    const Frame gl = render_on_device(scene, settings, "paper");
    EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 1e-3);
  }
}

// The eye and the light among needles and discs.
TEST_F(GlFrames, EllipsoidsAllAround) {
  Scene scene = on_film(ellipsoid_scene(16, 2.0, 200.0, 3), {32, 24});
  scene.camera.eye = {0.2, 0.1, 0.6};
  scene.lights[0].position = {-0.3, 0.2, -0.4};
  // Needles of less than a pixel differ by the rounding of single precision.
  Settings settings = quick_slices();
  const Frame cpu = render_frame(scene, settings);
  const Frame gl = render_on_device(scene, settings, "among them");
  EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 1e-2);
}

// Ellipsoids as thin as may be: nothing is cut off where the lists of tiles end, and what is deep
// along the disc only is light in the middle of no slice but where it lies.
TEST_F(GlFrames, ThinDiscs) {
  Scene scene = cloud_scene(1, 1.0);
  Medium discs;
  Random random(4);
  for (int i = 0; i < 12; ++i) {
    Gaussian g{random.point(0.6), 1.0, 0.0};
    const glm::dvec3 q = random.point(1.0);
    const double thin = random.power(-4.0, -3.0);
    g.set_radii({0.4, 0.4, 0.4 * thin}, glm::dquat(random.uniform(-1.0, 1.0), q.x, q.y, q.z));
    g.density = 0.05 / (0.4 * thin);
    discs.append(g);
  }
  scene.medium = discs;
  scene.film = {96, 72};
  const Frame cpu = render_frame(scene, quick_slices());
  const Frame gl = render_on_device(scene, quick_slices(), "thin discs");
  // Single precision knows the thinnest that are seen edge-on, or lit so, to a part in a thousand.
  EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 2e-2);
  EXPECT_LE(rel_rmse(gl.transmittance, cpu.transmittance), 5e-4);
}

}  // namespace
}  // namespace brume::gl
