// Light of all orders over grounds: how wide they are, and small things on them, change little.

#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

constexpr SourceGridSize usual_grid;

double mean_airlight(const Scene& scene,
                     const SourceGridSize& grid = {.nodes = usual_grid.nodes / 4}) {
  return mean_airlight(scene, all_orders(Settings{}.slices, grid));
}

Surface ground(double side) {
  return placed(Primitive::Shape::plane, {side, 1.0, side}, {0.0, 0.0, 0.0});
}

// Fog over a ground.
Scene fog_over(double side, double density) {
  Scene scene;
  scene.film = {16, 12};
  scene.camera = {{0, 2, 4}, {0, 0.5, 0}, {0, 1, 0}, 50.0};
  scene.medium.set_homogeneous_density(density);
  scene.surfaces = {ground(side)};
  return scene;
}

TEST(Grounds, OfAnyWidthAreLitAlikeByALightNearby) {
  // The mean of `brume render --airlight path:8192`, for a side of 40.
  constexpr double truth = 0.04179;
  for (const double side : {20.0, 1000.0}) {
    Scene scene = fog_over(side, 0.02);
    scene.lights = {{{1.0, 2.0, 1.0}, glm::dvec3(10.0), light::Point()}};
    EXPECT_NEAR(mean_airlight(scene), truth, 0.02 * truth) << side;
  }
}

TEST(Grounds, AreLitByALightThatAlmostTouchesThem) {
  // Its finest nodes must leave the coarser ones enough to reach all of the ground.
  Scene scene = fog_over(1000.0, 0.02);
  scene.lights = {{{1.0, 0.002, 1.0}, glm::dvec3(10.0), light::Point()}};
  const double close = mean_airlight(scene);
  scene.surfaces = {ground(20.0)};
  EXPECT_NEAR(mean_airlight(scene), close, 0.05 * close);
}

// In fog four mean free paths deep. Ordinates along a black ground saw light from over it as if it
// came from below: 12% too much.
TEST(Grounds, AreLitByTheSunAsTheyReflect) {
  struct Truth {
    double reflectance, airlight;  // the mean of `brume render --airlight path:8192`
  };
  for (const Truth& truth : {Truth{0.5, 0.2467}, Truth{0.0, 0.1392}}) {
    Scene scene = fog_over(60.0, 0.05);
    scene.surfaces[0].material.reflectance = glm::dvec3(truth.reflectance);
    scene.lights = {{{}, glm::dvec3(10.0), light::Directional{.direction = {-1.0, -1.0, -0.3}}}};
    EXPECT_NEAR(mean_airlight(scene), truth.airlight, 0.02 * truth.airlight) << truth.reflectance;
  }
}

// Where it is fourteen deep, the eye is in the dark: changes there were too small to go on for.
// The grid's layers were centred on a ground alone, and saw through it.
TEST(Grounds, InDeepFogAreNearlyAsLightWithSmallThingsOnThemOrNot) {
  Scene scene = fog_over(200.0, 0.05);
  scene.lights = {{{}, glm::dvec3(10.0), light::Directional{.direction = {-1.0, -1.0, -0.3}}}};
  // The mean of `brume render --airlight path:4096`. Cells are as wide as a fifth of a mean free
  // path near the ground and as one farther out, which lets 8% too much through.
  constexpr double truth = 0.1310;
  const double alone = mean_airlight(scene, usual_grid);
  EXPECT_NEAR(alone, truth, 0.1 * truth);
  scene.surfaces.push_back(placed(Primitive::Shape::box, glm::dvec3(0.02), {0.0, 0.01, 0.0}));
  EXPECT_NEAR(mean_airlight(scene, usual_grid), alone, 0.05 * alone);
}

// Without fog levels are around the cloud alone, and most of the floor that lights it is beyond the
// finest: this was 7% too dark.
TEST(Grounds, ThatAreWideAndLightLightCloudsOverThem) {
  Scene scene = cloud_scene(24, 0.5);
  scene.film = {15, 12};
  scene.surfaces = {wall(-0.4, 9.0, 0.9)};
  const Frame truth = render_frame(scene, path_traced(512));
  const Frame frame = render_frame(scene, all_orders(24, {.nodes = 20'000, .directions = 48}));
  EXPECT_LT(std::abs(difference(frame.airlight, truth.airlight).bias), 0.025);
}

// An eye that stands on a ground sees none of the nodes below it, however far apart nodes are: rays
// that rise took their light from there.
TEST(Grounds, AreNotSeenThroughByWhoStandsOnThem) {
  Scene scene = fog_over(20.0, 0.05);
  scene.lights = {{{2.0, 6.0, -2.0}, glm::dvec3(10.0), light::Point()}};
  scene.camera = {{0, 0.3, 4}, {0, 0.38, 0}, {0, 1, 0}, 2.0};
  const auto twice_scattered = [&](int nodes) {
    const SourceGridSize size{.nodes = nodes, .directions = 48};
    return mean_airlight(scene, all_orders(24, size)) -
           mean_airlight(scene, sliced(24, Scattering::single));
  };
  constexpr double truth = 0.0153;  // 160,000 nodes
  for (const int nodes : {5'000, 10'000, 20'000}) {
    EXPECT_NEAR(twice_scattered(nodes) / truth, 1.0, 0.2) << nodes;
  }
}

}  // namespace
}  // namespace brume
