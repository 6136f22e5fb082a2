#include "render/renderer.h"
#include "render/display/to_display.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <thread>

#include "brume/edits.h"
#include "core/scene/materials/brdf.h"
#include "core/transport/point_spread.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Scene busy_scene() {
  Scene scene = in_fog(cloud_scene(80, 2.0), 0.02);
  scene.lights.push_back({{-3, 2, 3}, {3, 5, 8}, {}});
  scene.surfaces.push_back(wall(-1.0, 2.0));
  scene.film = {48, 40};
  return scene;
}

std::size_t center_pixel(const Frame& frame) {
  return static_cast<std::size_t>(frame.film.height / 2 * frame.film.width + frame.film.width / 2);
}

TEST(Renderer, DiffuseWallHasTheRadianceItShould) {
  Scene scene = seen_by({{0, 0, 3}, {0, 0, 0}, {0, 1, 0}, 10.0}, {21, 21});
  scene.lights.push_back({{1.5, 0, 2}, {50, 20, 10}, {}});
  scene.surfaces.push_back(wall(0.0, 1.0, 0.8));
  const double d2 = 1.5 * 1.5 + 2.0 * 2.0;
  const double cosine = 2.0 / std::sqrt(d2);
  const double bare = 0.8 / std::numbers::pi * 50.0 * cosine / d2;
  Frame frame = render_frame(scene, paper_settings);
  const std::size_t i = center_pixel(frame);
  EXPECT_NEAR(frame.beauty[4 * i], bare, 1e-5 * bare);
  EXPECT_NEAR(frame.beauty[4 * i + 1], 0.4 * bare, 1e-5 * bare);
  EXPECT_NEAR(frame.depth[i], 3.0, 1e-5);
  EXPECT_EQ(frame.beauty[4 * i + 3], 1.0f);

  // In fog the light is attenuated on both ways, some is scattered on the way to the wall (eq. 25),
  // and airlight is added (eq. 29).
  scene.medium.set_homogeneous_density(0.1);
  frame = render_frame(scene, paper_settings);
  const double both_ways = bare * std::exp(-0.1 * (3.0 + std::sqrt(d2)));
  EXPECT_NEAR(frame.transmittance[3 * i], std::exp(-0.3), 1e-6);
  EXPECT_GT(frame.airlight[3 * i], 0.0f);
  const double T = 0.1 * std::sqrt(d2);
  const glm::dvec3 delta = glm::normalize(glm::dvec3(1.5, 0, 2));
  const double scattered_share =
      T *
      sh_evaluate(sh_convolve(sh_convolve(sh_basis(6, delta), SpreadTable::point()(T)),
                              clamped_cosine_sh()),
                  glm::dvec3(0, 0, 1)) /
      cosine;
  EXPECT_NEAR(frame.beauty[4 * i] - frame.airlight[3 * i], both_ways * (1.0 + scattered_share),
              1e-4 * both_ways);
}

TEST(Renderer, SurfacesCastShadows) {
  Scene scene = seen_by({{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 30.0}, {31, 31});
  scene.lights.push_back({{0, 4, 4}, {50, 50, 50}, {}});
  scene.surfaces.push_back(wall(0.0, 3.0));
  const Frame open = render_frame(scene, paper_settings);
  scene.surfaces.push_back(wall(0.0, 0.5));
  scene.surfaces.back().translate = {0, 2, 2};  // between the light and the middle of the wall
  const Frame shadowed = render_frame(scene, paper_settings);
  const std::size_t i = center_pixel(open);
  EXPECT_GT(open.beauty[4 * i], 0.0f);
  EXPECT_EQ(shadowed.beauty[4 * i], 0.0f);
}

TEST(Renderer, SurfacesArePlacedByTheirTransform) {
  Scene scene = seen_by({{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 10.0}, {9, 9});
  scene.surfaces.push_back(ball_surface(64, 2.0, {0, 0, 1}));
  EXPECT_NEAR(
      render_frame(scene, paper_settings).depth[center_pixel(render_frame(scene, paper_settings))],
      7.0, 1e-2);
  // A wall turned by 90 degrees about y is seen edge on.
  scene.surfaces = {wall(0.0, 1.0)};
  scene.surfaces[0].translate = {0.3, 0, 0};
  scene.surfaces[0].rotate = glm::dquat(std::sqrt(0.5), 0, std::sqrt(0.5), 0);
  const Frame frame = render_frame(scene, paper_settings);
  EXPECT_TRUE(std::isinf(frame.depth[center_pixel(frame)]));
}

TEST(Renderer, ReusesOnlyUnchangedData) {
  Scene scene = busy_scene();
  Renderer renderer;
  const auto check = [&](const char* what) {
    const Frame kept = render_frame(renderer, scene, paper_settings);
    EXPECT_EQ(kept.beauty, render_frame(scene, paper_settings).beauty) << what;
  };
  check("first");
  scene.camera.eye = {0.5, 0.4, 3.5};
  check("camera moved");
  scene.lights[0].position.x += 0.7;
  check("light moved");
  scene.lights.erase(scene.lights.begin());
  check("light gone");
  Gaussian g = scene.medium.gaussian(3);
  g.radius *= 2.0;
  MediumEdit::change(scene.medium, std::vector{scene.medium.ids()[3]}, std::vector{g})
      .apply(scene.medium);
  check("Gaussian changed");
  scene.medium.set_homogeneous_density(0.0);
  check("b0 changed");
  scene.surfaces[0].translate.z -= 0.4;
  check("surface moved");
  scene.surfaces[0].material.reflectance = glm::dvec3(0.9, 0.1, 0.1);
  check("material changed");
  scene.film = {33, 17};
  check("film changed");
}

TEST(Renderer, StopsOnRequest) {
  Scene scene = on_film(cloud_scene(300, 3.0), {1024, 1024});
  Settings settings;
  settings.airlight = AirlightMethod::reference;  // minutes, if it went on
  std::stop_source source;
  double last = 0.0;
  std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    source.request_stop();
  });
  Renderer renderer;
  EXPECT_FALSE(renderer.render(scene, scene.camera, scene.film, settings, source.get_token(),
                               [&](double fraction) { last = fraction; }));
  EXPECT_LT(last, 1.0);
}

TEST(Renderer, LightsSwitchedOffAreAsIfNotThere) {
  Scene scene = on_film(busy_scene(), {16, 16});
  scene.lights = {{{2, 3, 2}, {10, 10, 10}, {}}, {{-2, 1, 3}, {1, 5, 9}, {}}};
  Scene one = scene;
  scene.lights[1].on = false;
  one.lights.pop_back();
  const Frame frame = render_frame(scene, paper_settings);
  EXPECT_EQ(frame.beauty, render_frame(one, paper_settings).beauty);
  bool found = false;
  for (const SkippedStage& s : frame.statistics.skipped) {
    found = found || (s.stage == Stage::lights && s.why == "switched off: 1");
  }
  EXPECT_TRUE(found);
  scene.lights[1].on = true;
  EXPECT_NE(frame.beauty, render_frame(scene, paper_settings).beauty);
}

TEST(Renderer, CountsPairs) {
  const Frame frame = render_frame(busy_scene(), paper_settings);
  EXPECT_EQ(frame.statistics.gaussians_total, 80u);
  EXPECT_EQ(frame.statistics.gaussians_used, 80u);
  EXPECT_GT(frame.statistics.light_pairs, 0u);
  EXPECT_GT(frame.statistics.view_pairs, 0u);
  EXPECT_LE(frame.statistics.view_pairs, 80u * 48u * 40u + 80u * 80u);

  Scene small = on_film(busy_scene(), {6, 5});
  Settings reference;
  reference.airlight = AirlightMethod::reference;
  const FrameStatistics counted = render_frame(small, reference).statistics;
  EXPECT_GT(counted.view_pairs, 0u);
  EXPECT_GT(counted.light_pairs, counted.view_pairs);  // at each point of a ray one to the light
}

TEST(Display, PreservesColoursBelowTheKnee) {
  Frame frame;
  frame.film = {3, 1};
  frame.beauty = {0, 0, 0, 0, 0.2f + 0.04f, 0.2f + 0.04f, 0.2f + 0.04f, 1, 1e30f, 1, 0, 1};
  const auto bytes = to_display(frame, {});
  EXPECT_EQ(bytes[0], 0);
  // sRGB of 0.2 (the curve takes away 0.04), dithered.
  EXPECT_NEAR(bytes[3], 123.55, 1.0);
  EXPECT_GE(bytes[6], 254);
}

}  // namespace
}  // namespace brume
