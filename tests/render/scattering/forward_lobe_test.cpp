// The forward lobe of the phase function: fog, Gaussians, skies and surfaces treat it alike.

#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

// Enough for what holds on any grid.
constexpr SourceGridSize coarse_grid{.nodes = 8000, .directions = 64};

// The relative RMS difference of the picture from 1 in a furnace: what only scatters and reflects
// under a sky of 1 is 1 everywhere.
double furnace_error(Scene scene, double anisotropy, const SourceGridSize& grid = coarse_grid) {
  scene.film = {8, 6};
  scene.lights.clear();
  scene.environment = even_sky(1.0f);
  scene.optics.anisotropy = anisotropy;
  const Frame frame = render_frame(scene, all_orders(24, grid));
  double squares = 0.0;
  for (std::size_t i = 0; i < 48; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      squares += std::pow(static_cast<double>(frame.beauty[4 * i + c]) - 1.0, 2.0);
    }
  }
  return std::sqrt(squares / 144.0);
}

constexpr double anisotropies[] = {-0.5, 0.3, 0.9};

TEST(ForwardLobe, KeepsAUniformFieldInFog) {
  for (const double g : anisotropies) {
    Scene scene;
    scene.camera = {{0, 0.5, 8}, {0, 0, 0}, {0, 1, 0}, 50.0};
    scene.medium.set_homogeneous_density(0.1);
    EXPECT_LT(furnace_error(scene, g), 0.005) << g;
  }
}

TEST(ForwardLobe, KeepsAUniformFieldInFogAndGaussians) {
  EXPECT_LT(furnace_error(in_fog(cloud_scene(5, 3.0), 0.02), 0.9, {}), 0.005);
  // Denser fog shows the nodes of coarser levels more: 0.503%.
  EXPECT_LT(furnace_error(in_fog(cloud_scene(5, 3.0), 0.3), -0.5), 0.006);
}

// Two small balls decide how far the fog reaches: 2.8 mean free paths.
TEST(ForwardLobe, KeepsAUniformFieldBesideSurfaces) {
  Scene scene;
  scene.camera = {{0, 1.7, 14}, {0, 4, 0}, {0, 1, 0}, 55.0};
  scene.medium.set_homogeneous_density(0.05);
  for (const double x : {20.0, -20.0}) {
    scene.surfaces.push_back(placed(Primitive::Shape::sphere, glm::dvec3(0.1), {x, 0.0, x}, 1.0));
  }
  for (const double g : {-0.5, 0.9}) {
    EXPECT_LT(furnace_error(scene, g, {.nodes = 40'000}), 0.014) << g;
  }
}

// A cloud over a floor on which a spot light under it shines, and nothing else.
Scene over_a_lit_floor() {
  Scene scene = cloud_scene(20, 1.0);
  scene.film = {16, 12};
  scene.camera = {{0, -0.8, 5}, {0, 0.2, 0}, {0, 1, 0}, 40.0};
  scene.surfaces.push_back(placed(Primitive::Shape::box, {12, 1, 12}, {0, -2, 0}, 0.8));
  scene.lights = {{{0, -1.2, 0}, glm::dvec3(4.0), light::Spot{{0, -1, 0}, 100.0, 140.0}}};
  scene.optics.anisotropy = 0.85;
  return scene;
}

// The airlight by four bands alone was 17% off, and as much too dark. What is left is of the light
// on the floor, whose spot is two nodes and a few directions of the eye wide.
TEST(ForwardLobe, ScattersTheLightOfSurfacesToTheEye) {
  const Scene scene = over_a_lit_floor();
  const Frame truth = traced_truth(scene, 4096);
  const Frame frame = render_frame(scene, all_orders(24));
  const Difference airlight = difference(frame.airlight, truth.airlight);
  EXPECT_LT(airlight.relative_rmse, std::hypot(0.06, relative_noise(truth)->airlight));
  EXPECT_LT(std::abs(airlight.bias), 0.06);
}

// At the horizon rays run along the floor, whose parts are seen at grazing angles. There the
// airlight was 13% too dark: what the table lacks below the floor came from rays above it. What is
// left is of the grid's nodes: 1 to 2% less with 300,000.
TEST(ForwardLobe, ScattersTheLightOfAFloorUpToTheHorizon) {
  Scene scene;
  scene.film = {12, 8};
  scene.camera = {{-4, 1.7, 24}, {-6, 1.2, 0}, {0, 1, 0}, 12.0};
  scene.medium.set_homogeneous_density(0.0017);
  scene.optics.anisotropy = 0.85;
  scene.lights = {{{}, glm::dvec3(5.0), light::Directional{{0, -1, 0}}}};
  scene.surfaces.push_back(placed(Primitive::Shape::plane, {174, 1, 174}, {0, 0, 0}, 0.5));
  const Frame truth = traced_truth(scene, 4096);
  const Frame frame = render_frame(scene, all_orders(24, {.nodes = 40'000}));
  const Difference airlight = difference(frame.airlight, truth.airlight);
  EXPECT_LT(std::abs(airlight.bias), 0.05);
  EXPECT_LT(airlight.relative_rmse, std::hypot(0.06, relative_noise(truth)->airlight));
}

// A wall with a window, black, that parts fog under a sky: the eye looks at it and through it.
Scene before_a_window() {
  Scene scene;
  scene.film = {12, 8};
  scene.camera = {{0, 0, 4}, {0.6, 0, 0}, {0, 1, 0}, 60.0};
  scene.medium.set_homogeneous_density(0.07);
  scene.optics.extent = 10.0;
  scene.optics.anisotropy = 0.85;
  scene.environment = even_sky(1.0f);
  for (const double side : {-1.0, 1.0}) {
    const auto box = Primitive::Shape::box;
    scene.surfaces.push_back(placed(box, {12, 3, 0.2}, {0, 2.2 * side, 0}, 0.0));
    scene.surfaces.push_back(placed(box, {5, 1.4, 0.2}, {3.5 * side, 0, 0}, 0.0));
  }
  return scene;
}

// Before the wall, where light comes only from aside, the airlight was twice as much: of the sky a
// place knew how much of each 16th it sees. What is left is of the table beside the window's edges,
// and a percent of the paths' noise.
TEST(ForwardLobe, ScattersTheSkyThatIsSeenThroughAWindow) {
  const Scene scene = before_a_window();
  const Frame truth = traced_truth(scene, 4096);
  const Frame frame = render_frame(scene, all_orders(24, {.nodes = 20'000}));
  double apart = 0.0;
  for (std::size_t i = 0; i < truth.airlight.size(); i += 3) {
    apart += std::abs(frame.airlight[i] / truth.airlight[i] - 1.0f) / 96.0;
  }
  EXPECT_LT(apart, 0.045);
}

// Walls of a closed room of fog.
Scene room() {
  Scene scene;
  scene.film = {8, 6};
  scene.camera = {{-1.5, 1.6, 3.1}, {0.8, 1.2, -1.5}, {0, 1, 0}, 60.0};
  scene.medium.set_homogeneous_density(0.1);
  scene.environment = even_sky(1.0f);
  for (const double side : {-1.0, 1.0}) {
    const auto box = Primitive::Shape::box;
    scene.surfaces.push_back(placed(box, {6.4, 0.2, 7.4}, {0.0, 1.5 + 1.6 * side, 0.0}, 0.5));
    scene.surfaces.push_back(placed(box, {0.2, 3.0, 7.0}, {3.1 * side, 1.5, 0.0}, 0.5));
    scene.surfaces.push_back(placed(box, {6.4, 3.0, 0.2}, {0.0, 1.5, 3.6 * side}, 0.5));
  }
  return scene;
}

double airlight_within(const Scene& scene) {
  return mean_airlight(scene, all_orders(24, coarse_grid));
}

// The lobe of a sky asked no surface: 3% of its radiance were in there for g = 0.6.
TEST(ForwardLobe, StaysOutOfClosedRooms) {
  Scene scene = room();
  scene.optics.anisotropy = 0.85;
  EXPECT_LT(airlight_within(scene), 1e-4);
  scene.optics.anisotropy = 0.6;
  EXPECT_LT(airlight_within(scene), 1e-4);
}

// Levels around Gaussians alone saw through the walls: those of the smallest did not know the room,
// and those of the largest cross its floor.
TEST(ForwardLobe, StaysOutOfClosedRoomsWithAGaussian) {
  for (const double radius : {0.2, 0.5, 0.8}) {
    Scene scene = room();
    scene.optics.anisotropy = 0.6;
    scene.medium.append({{0.0, 1.5, 0.0}, radius, 0.5});
    EXPECT_LT(airlight_within(scene), 1e-4) << radius;
  }
}

}  // namespace
}  // namespace brume
