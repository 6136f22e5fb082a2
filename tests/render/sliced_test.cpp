#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Settings sliced(int slices) {
  return sliced_settings({}, slices);
}

Settings reference() {
  Settings settings;
  settings.airlight = AirlightMethod::reference;
  return settings;
}

struct Row {
  const char* name;
  Scene scene;
  double coarse, fine;  // bounds of the relative RMSE with 16 and with 64 slices
};

Scene with_light_at(Scene scene, const glm::dvec3& position) {
  scene.lights[0].position = position;
  return scene;
}

Scene in_fog(Scene scene, double b0) {
  scene.medium.set_homogeneous_density(b0);
  return scene;
}

Scene scattering(Scene scene, double anisotropy) {
  scene.optics.anisotropy = anisotropy;
  return scene;
}

Scene absorbing(Scene scene) {
  scene.optics.albedo = {0.4, 0.7, 0.7};
  return scene;
}

Scene shaft() {
  Scene scene = in_fog(cloud_scene(20, 0.5), 0.02);
  scene.lights[0].position = {0.2, 0.1, -4.0};
  scene.surfaces.push_back(wall(-2.0, 0.4));
  return scene;
}

Scene eye_inside() {
  Scene scene = cloud_scene(30, 2.0);
  scene.camera.eye = {0.1, 0.0, 0.3};
  return scene;
}

Scene cut_by_a_surface() {
  Scene scene = cloud_scene(30, 2.0);
  scene.surfaces.push_back(wall(0.05, 3.0));
  return scene;
}

std::vector<Row> rows() {
  return {
      {"30 Gaussians, depth 1", cloud_scene(30, 1.0), 0.01, 0.002},
      {"300 Gaussians, depth 0.3", cloud_scene(300, 0.3), 0.005, 0.001},
      {"300 Gaussians, depth 3", cloud_scene(300, 3.0), 0.01, 0.002},
      {"300 Gaussians, depth 10", cloud_scene(300, 10.0), 0.02, 0.004},
      {"3,000 Gaussians, depth 3", cloud_scene(3000, 3.0), 0.01, 0.002},
      {"light inside", with_light_at(cloud_scene(300, 1.0), {0.2, 0.1, 0.3}), 0.02, 0.005},
      {"eye inside", eye_inside(), 0.01, 0.003},
      {"cut by a surface", cut_by_a_surface(), 0.02, 0.004},
      {"fog alone", in_fog(cloud_scene(1, 1e-12), 0.1), 0.005, 0.001},
      {"cloud in fog", in_fog(cloud_scene(300, 1.0), 0.02), 0.01, 0.002},
      {"light inside fog", in_fog(with_light_at(cloud_scene(30, 0.5), {0.2, 0.3, 0.1}), 0.1), 0.04,
       0.004},
      {"forward scattering", scattering(in_fog(cloud_scene(100, 1.0), 0.02), 0.7), 0.02, 0.004},
      {"backward scattering", scattering(cloud_scene(100, 1.0), -0.5), 0.01, 0.002},
      {"absorbing", absorbing(cloud_scene(100, 1.0)), 0.01, 0.002},
      {"shaft", shaft(), 0.05, 0.02},
  };
}

// The bounds are about twice what is measured; each scene gets better with more slices.
TEST(Sliced, ConvergesToTheReference) {
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.name);
    const Frame truth = render_frame(row.scene, reference());
    const double coarse =
        difference(render_frame(row.scene, sliced(16)).airlight, truth.airlight).relative_rmse;
    const double fine =
        difference(render_frame(row.scene, sliced(64)).airlight, truth.airlight).relative_rmse;
    EXPECT_LT(coarse, row.coarse);
    EXPECT_LT(fine, row.fine);
    EXPECT_LT(fine, coarse);
  }
}

TEST(Sliced, TransmittanceIsThatOfTheReference) {
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.name);
    const Frame a = render_frame(row.scene, sliced(16));
    const Frame b = render_frame(row.scene, reference());
    for (std::size_t i = 0; i < a.transmittance.size(); ++i) {
      ASSERT_NEAR(a.transmittance[i], b.transmittance[i], 1e-3);
    }
  }
}

}  // namespace
}  // namespace brume
