// Light of all orders from frame to frame, while the camera or a light moves evenly.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "core/math/srgb.h"
#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

constexpr int block_side = 8;

// The means of blocks of pixels as they are shown, with light of `white` as white.
std::vector<double> shown_blocks(const Frame& frame, double white) {
  const int columns = frame.film.width / block_side;
  std::vector<double> blocks(
      static_cast<std::size_t>(columns * (frame.film.height / block_side)) * 3, 0.0);
  for (std::size_t i = 0; 4 * i < frame.beauty.size(); ++i) {
    const int x = static_cast<int>(i) % frame.film.width / block_side;
    const int y = static_cast<int>(i) / frame.film.width / block_side;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = std::clamp(double{frame.beauty[4 * i + c]} / white, 0.0, 1.0);
      blocks[3 * static_cast<std::size_t>(y * columns + x) + c] +=
          srgb_encoded(value) / (block_side * block_side);
    }
  }
  return blocks;
}

// The largest second difference in time of what is shown of any block. Evenly moving, light has
// small ones; what jumps has ones as large as its jump.
double max_flicker(const std::function<Scene(double)>& scene_at, int frames) {
  constexpr double white_over_mean = 5.0;
  Renderer renderer;
  Settings settings = all_orders(Settings{}.slices);
  settings.samples = 64;  // else edges jump from pixel to pixel
  double white = 0.0;
  double flicker = 0.0;
  std::vector<std::vector<double>> shown;
  for (int k = 0; k < frames; ++k) {
    const Scene scene = scene_at(static_cast<double>(k) / (frames - 1));
    const Frame frame = *renderer.render(scene, scene.camera, scene.film, settings);
    if (k == 0) white = white_over_mean * mean_airlight(frame);
    shown.push_back(shown_blocks(frame, white));
    if (k < 2) continue;
    for (std::size_t i = 0; i < shown[0].size(); ++i) {
      const auto last = shown.end() - 1;
      flicker = std::max(flicker, std::abs((*last)[i] - 2.0 * (*(last - 1))[i] + (*(last - 2))[i]));
    }
  }
  return flicker;
}

// A third of the step between two values of 8 bits.
constexpr double invisible = 1.0 / 255.0 / 3.0;

Scene light_over_a_ground() {
  Scene scene;
  scene.film = {48, 32};
  scene.camera = {{0, 2, 8}, {0, 1, 0}, {0, 1, 0}, 50.0};
  scene.medium.set_homogeneous_density(0.05);
  scene.surfaces = {placed(Primitive::Shape::plane, {40, 1, 40}, {0, 0, 0}),
                    placed(Primitive::Shape::box, {1, 2, 1}, {-1.5, 1, 0})};
  scene.lights = {{{1.0, 3.0, 0.0}, glm::dvec3(40.0), light::Point()}};
  return scene;
}

TEST(Flicker, OfAMovingCameraIsInvisible) {
  const double flicker = max_flicker(
      [](double t) {
        Scene scene = light_over_a_ground();
        scene.camera.eye += glm::dvec3(0.1 * t, 0.03 * t, -0.1 * t);
        return scene;
      },
      12);
  EXPECT_LT(flicker, invisible);
}

TEST(Flicker, OfAMovingLightIsInvisible) {
  const double flicker = max_flicker(
      [](double t) {
        Scene scene = light_over_a_ground();
        scene.lights[0].position += glm::dvec3(0.1 * t, 0.05 * t, 0.05 * t);
        return scene;
      },
      12);
  EXPECT_LT(flicker, invisible);
}

}  // namespace
}  // namespace brume
