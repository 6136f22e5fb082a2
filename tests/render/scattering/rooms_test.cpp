// Light of all orders in a room with a window, as its walls let it in.

#include <gtest/gtest.h>

#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Surface block(const glm::dvec3& low, const glm::dvec3& high) {
  return placed(Primitive::Shape::box, high - low, 0.5 * (low + high));
}

// Six by seven by three, walls of 0.2; the window is in the wall towards +x, which the camera does
// not see.
Scene room_with_window() {
  Scene scene;
  scene.film = {16, 12};
  scene.camera = {{2.5, 1.6, 2.9}, {-2.0, 1.2, -1.5}, {0, 1, 0}, 60.0};
  scene.medium.set_homogeneous_density(0.05);
  scene.surfaces = {
      block({-3.2, -0.2, -3.7}, {3.2, 0.0, 3.7}), block({-3.2, 3.0, -3.7}, {3.2, 3.2, 3.7}),
      block({-3.2, 0.0, -3.7}, {-3.0, 3.0, 3.7}), block({-3.0, 0.0, -3.7}, {3.2, 3.0, -3.5}),
      block({-3.0, 0.0, 3.5}, {3.2, 3.0, 3.7}),   block({3.0, 0.0, -3.5}, {3.2, 0.9, 3.5}),
      block({3.0, 2.3, -3.5}, {3.2, 3.0, 3.5}),   block({3.0, 0.9, -3.5}, {3.2, 2.3, -1.5}),
      block({3.0, 0.9, 1.0}, {3.2, 2.3, 3.5})};
  return scene;
}

// A quarter of the usual nodes.
const Settings of_all_orders =
    all_orders(Settings{}.slices, {.nodes = Settings{}.source_grid.nodes / 4});

double mean_airlight_in(const Scene& scene) {
  return mean_airlight(scene, of_all_orders);
}

// The grid ends at the outer walls: what lights these from outside did light the room.
TEST(Rooms, AreDarkUnderASunThatShinesOnTheirBack) {
  Scene scene = room_with_window();
  scene.medium.set_homogeneous_density(1e-5);
  scene.lights = {{{}, glm::dvec3(3.0), light::Directional{.direction = {0.85, -0.07, -0.5}}}};
  const Frame frame = render_frame(scene, of_all_orders);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) EXPECT_LT(frame.beauty[4 * i], 1e-3f) << i;
}

// A plain of 25 times its side made cells of the grid and of the shadow map as wide as the room.
TEST(Rooms, AreDarkWhereverTheyStand) {
  Scene scene;
  scene.film = {16, 12};
  scene.camera = {{1.7, 1.9, 1.7}, {-1.5, 1.0, -1.5}, {0, 1, 0}, 60.0};
  scene.medium.set_homogeneous_density(0.05);
  scene.lights = {{{}, glm::dvec3(10.0), light::Directional{.direction = {-1.0, -1.0, -0.3}}}};
  scene.surfaces = {block({-50.0, -0.1, -50.0}, {50.0, 0.0, 50.0})};
  const double open = mean_airlight_in(scene);
  scene.surfaces.push_back(block({-2.0, 0.0, -2.0}, {2.0, 3.0, 2.0}));
  scene.surfaces.push_back(block({-2.2, -0.2, -2.2}, {2.2, 3.2, 2.2}));
  EXPECT_LT(mean_airlight_in(scene), 1e-3 * open);
}

// Without fog, walls did not light each other, and the sky shone through them.
TEST(Rooms, AreLitThroughAWindowAsByPaths) {
  for (const double density : {0.05, 0.0}) {
    Scene scene = room_with_window();
    scene.medium.set_homogeneous_density(density);
    scene.environment = even_sky(1.0f);
    const Difference picture = difference(render_frame(scene, of_all_orders).beauty,
                                          render_frame(scene, path_traced(128)).beauty);
    EXPECT_NEAR(picture.bias, 0.0, 0.04) << density;
  }
}

TEST(Rooms, AreLitByALampAsByPathsWithoutFog) {
  Scene scene = room_with_window();
  scene.medium.set_homogeneous_density(0.0);
  scene.lights = {{{-1.0, 2.0, 0.5}, glm::dvec3(5.0), light::Point()}};
  const Difference picture = difference(render_frame(scene, of_all_orders).beauty,
                                        render_frame(scene, path_traced(128)).beauty);
  EXPECT_NEAR(picture.bias, 0.0, 0.03);
  EXPECT_LT(picture.relative_rmse, 0.08);
}

// A light just below the ceiling of a closed room of 6 by 10 by 3. The grid's levels left the room,
// which had few nodes then: 21% were missing, and 11% with smoke, around which all fine nodes were.
TEST(Rooms, AreLitFromJustBelowTheirCeilings) {
  Scene scene;
  scene.film = {16, 12};
  scene.camera = {{2.5, 1.6, 4.5}, {-1.5, 1.2, -2.0}, {0, 1, 0}, 60.0};
  scene.medium.set_homogeneous_density(0.12);
  scene.optics.albedo = glm::dvec3(1.0);
  scene.lights = {{{-0.7, 2.93, -1.0}, glm::dvec3(10.0), light::Point()}};
  scene.surfaces = {
      block({-3.2, -0.2, -5.2}, {3.2, 0.0, 5.2}), block({-3.2, 3.0, -5.2}, {3.2, 3.2, 5.2}),
      block({-3.2, 0.0, -5.2}, {-3.0, 3.0, 5.2}), block({3.0, 0.0, -5.2}, {3.2, 3.0, 5.2}),
      block({-3.0, 0.0, -5.2}, {3.0, 3.0, -5.0}), block({-3.0, 0.0, 5.0}, {3.0, 3.0, 5.2})};
  // The means of `brume render --airlight path:8192`.
  EXPECT_NEAR(mean_airlight_in(scene), 0.1001, 0.03 * 0.1001);
  for (int i = 0; i < 5; ++i) {
    scene.medium.append({{-1.0 + 0.5 * i, 0.8 + 0.3 * i, -1.5 - 0.4 * i}, 0.4, 0.4});
  }
  EXPECT_NEAR(mean_airlight_in(scene), 0.1010, 0.03 * 0.1010);
}

}  // namespace
}  // namespace brume
