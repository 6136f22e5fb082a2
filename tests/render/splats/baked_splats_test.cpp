#include "render/splats/baked_splats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/spherical_harmonics.h"
#include "core/scene/camera_rays.h"
#include "core/transport/optical_depth.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

std::vector<SplatColor> baked(const Scene& scene, const Settings& settings) {
  return *bake_splats(scene, settings, [](const glm::vec3& radiance) { return radiance; }, {});
}

glm::vec3 seen(const SplatColor& color, const glm::dvec3& w) {
  const ShVector<double> basis = sh_basis(4, w);
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < color.size(); ++i) sum += static_cast<float>(basis[i]) * color[i];
  return sum;
}

// A thin Gaussian far from its light scatters as much of it into all directions.
TEST(BakedSplats, ThinOneSendsWhatArrives) {
  Scene scene;
  Gaussian g{{0, 0, 0}, 0.1, 0.01};
  g.set_radii({0.1, 0.2, 0.05}, glm::normalize(glm::dquat(0.3, 0.5, -0.2, 0.7)));
  scene.medium.append(g);
  scene.lights = {{{0, 10, 0}, {50, 100, 200}, {}}};
  const std::vector<SplatColor> colors = baked(scene, sliced(24));
  ASSERT_EQ(colors.size(), 1u);
  const double expected = 100.0 / (4.0 * std::numbers::pi * 100.0);
  for (const glm::dvec3& w : {glm::dvec3(0, 1, 0), {0, 0, 1}, {0.6, -0.8, 0}}) {
    const glm::vec3 color = seen(colors[0], w);
    EXPECT_NEAR(color.g, expected, 0.01 * expected);
    EXPECT_NEAR(color.r, 0.5 * expected, 0.005 * expected);
    EXPECT_NEAR(color.b, 2.0 * expected, 0.02 * expected);
  }
}

// Opaque ones are bright where they are lit: seen from the light, not from behind.
TEST(BakedSplats, OpaqueOnesHaveADarkSide) {
  Scene scene;
  scene.medium.append({{0, 0, 0}, 0.5, 8.0});
  scene.lights = {{{0, 5, 0}, {100, 100, 100}, {}}};
  const SplatColor color = baked(scene, sliced(24))[0];
  EXPECT_GT(seen(color, {0, -1, 0}).g, 4.0f * seen(color, {0, 1, 0}).g);
}

// Splats over each other are the airlight, where each is much smaller than the cloud.
TEST(BakedSplats, TogetherTheyAreTheAirlight) {
  for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
    Scene scene = ellipsoid_scene(300, 1.5, 3.0);
    scene.optics.albedo = {0.9, 0.8, 0.6};
    scene.optics.anisotropy = 0.3;
    const std::vector<SplatColor> colors = baked(scene, sliced(24, scattering));
    const glm::dvec3 eye = scene.camera.eye;
    scene.film = {9, 9};
    scene.camera.vertical_fov = 12.0;
    const Frame frame = render_frame(scene, sliced(64, scattering));
    double sum = 0.0;
    double error = 0.0;
    const CameraRays rays(scene.camera, scene.film);
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) {
        const glm::dvec3 w = rays.direction(x + 0.5, y + 0.5);
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < scene.medium.size(); ++i) {
          order.emplace_back(glm::dot(scene.medium.centers()[i] - eye, w), i);
        }
        std::ranges::sort(order);
        double transmittance = 1.0;
        double color = 0.0;
        for (const auto& [distance, i] : order) {
          const double depth = optical_depth(scene.medium.gaussian(i), eye, eye + 20.0 * w) / 0.8;
          const glm::dvec3 from_eye = glm::normalize(scene.medium.centers()[i] - eye);
          color += transmittance * -std::expm1(-depth) *
                   static_cast<double>(seen(colors[i], from_eye).g);
          transmittance *= std::exp(-depth);
        }
        const double right = frame.airlight[3 * static_cast<std::size_t>(9 * y + x) + 1];
        sum += right * right;
        error += (color - right) * (color - right);
      }
    }
    EXPECT_LT(std::sqrt(error / sum), 0.12);
  }
}

TEST(BakedSplats, NothingIsLitByNothing) {
  Scene scene = cloud_scene(3, 1.0);
  scene.lights.clear();
  for (const SplatColor& color : baked(scene, sliced(12))) {
    for (const glm::vec3& c : color) EXPECT_EQ(c, glm::vec3(0.0f));
  }
  EXPECT_TRUE(baked(Scene(), sliced(12)).empty());
}

}  // namespace
}  // namespace brume
