// Shadow rays near surfaces whose sizes differ by orders of magnitude.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "render/visibility/coordinate_center.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"
#include "tests/render/visibility/box_on_floor.h"

namespace brume {
namespace {

Surface floor_of(double size) {
  return primitive_surface(Primitive::Shape::plane, {size, 1, size}, {});
}

double difference_to(const Frame& expected, const Scene& scene) {
  return rel_rmse(render_frame(scene, sliced(8)).beauty, expected.beauty);
}

float max_beauty(const Frame& frame) {
  float most = 0.0f;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, frame.beauty[4 * i + c]);
  }
  return most;
}

TEST(ShadowMargins, KeepShadowsOnFloorsOfAnySize) {
  for (const Light& light : {oblique_sun(), light_beside_box(1.0)}) {
    const Frame expected = render_frame(box_on_floor(floor_of(40.0), light), sliced(8));
    for (const double size : {1e4, 1e5, 5e6, 1e7}) {
      EXPECT_LT(difference_to(expected, box_on_floor(floor_of(size), light)), 1e-4) << size;
      EXPECT_LT(difference_to(expected, box_on_floor(two_triangles(size), light)), 1e-4) << size;
    }
  }
}

TEST(ShadowMargins, KeepShadowsOfSmallThings) {
  const Frame expected =
      render_frame(box_on_floor(floor_of(40.0), light_beside_box(1.0)), sliced(8));
  for (const double box : {0.1, 0.001}) {
    const Scene scene = box_on_floor(floor_of(1e4), light_beside_box(box), box);
    EXPECT_LT(difference_to(expected, scene), 1e-4) << box;
  }
}

// The picture is the same but for the sun, which shines at the middle of all.
TEST(ShadowMargins, KeepShadowsBesideFarObjects) {
  for (const Light& light : {oblique_sun(), light_beside_box(1.0)}) {
    const Scene near = box_on_floor(floor_of(40.0), light);
    const Frame expected = render_frame(near, sliced(8));
    for (const double size : {0.1, 2.0, 1e6}) {
      Scene scene = near;
      const glm::dvec3 behind(0.0, 0.0, 2e5 + 10.0 * size);
      scene.surfaces.push_back(
          primitive_surface(Primitive::Shape::sphere, glm::dvec3(size), behind));
      EXPECT_LT(difference_to(expected, scene), 1e-3) << size;
    }
  }
}

// Rounding of coordinates is all that a tilted floor may lose: it is 4e-4 u here.
TEST(ShadowMargins, KeepShadowsOnTiltedFloors) {
  const glm::dquat turn = glm::angleAxis(0.6, glm::dvec3(1, 0, 0));
  const auto tilted = [&](double size) {
    Scene scene = box_on_floor(floor_of(size), light_beside_box(1.0));
    for (Surface& surface : scene.surfaces) {
      surface.translate = turn * surface.translate;
      surface.rotate = turn;
    }
    for (glm::dvec3* p :
         {&scene.camera.eye, &scene.camera.target, &scene.camera.up, &scene.lights[0].position}) {
      *p = turn * *p;
    }
    return scene;
  };
  const Frame expected = render_frame(tilted(40.0), sliced(8));
  EXPECT_LT(difference_to(expected, tilted(1e4)), 2e-2);
}

TEST(ShadowMargins, LeaveClosedRoomsDark) {
  for (const double floor : {20.0, 1e4, 1e5}) {
    const Scene scene = closed_room(floor);
    EXPECT_EQ(max_beauty(render_frame(scene, sliced(8))), 0.0f) << floor;
    EXPECT_EQ(max_beauty(render_frame(scene, path_traced(8))), 0.0f) << floor;
  }
}

TEST(ShadowMargins, LeavePlanesUnshadowedByThemselves) {
  Random random(4);
  for (int n = 0; n < 20; ++n) {
    const glm::dquat turn =
        glm::normalize(glm::dquat(random.uniform(-1.0, 1.0), random.point(1.0)));
    Scene scene = box_on_floor(
        n % 2 == 0 ? floor_of(random.power(0.0, 5.0)) : two_triangles(random.power(0.0, 5.0)),
        oblique_sun());
    scene.surfaces.resize(1);
    scene.surfaces[0].rotate = turn;
    for (glm::dvec3* v : {&scene.camera.eye, &scene.camera.target, &scene.camera.up,
                          &scene.lights[0].as<light::Directional>()->direction}) {
      *v = turn * *v;
    }
    const Frame frame = render_frame(scene, sliced(8));
    const float most = max_beauty(frame);
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (!std::isfinite(frame.depth[i])) continue;
      EXPECT_GT(frame.beauty[4 * i], 0.999f * most) << n;
    }
  }
}

TEST(ShadowMargins, LeaveRoundMeshesUnshadowedByThemselves) {
  for (const double size : {1.0, 1e-3, 1e4}) {
    for (const int rings : {8, 60}) {
      Scene scene = seen_by({size * glm::dvec3(0, 0, 4), {0, 0, 0}, {0, 1, 0}, 40.0}, {80, 60});
      scene.lights = {oblique_sun()};
      scene.lights[0].as<light::Directional>()->direction = {0, 0, -1};
      scene.surfaces.emplace_back().mesh = ball_mesh(rings);
      scene.surfaces[0].scale = size;
      const Frame frame = render_frame(scene, sliced(8));
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        if (!std::isfinite(frame.depth[i])) continue;
        EXPECT_GT(frame.beauty[4 * i], 0.0f) << size;
      }
    }
  }
}

Box cube(const glm::dvec3& center, double size) {
  return {center - 0.5 * size, center + 0.5 * size};
}

Box around(std::span<const Box> boxes) {
  Box all = boxes[0];
  for (const Box& box : boxes) all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  return all;
}

TEST(CoordinateCenter, IsTheMiddleOfOrdinaryScenes) {
  const std::array boxes{cube({0, 0, 0}, 10.0), cube({40, 3, 2}, 0.1)};
  EXPECT_EQ(coordinate_center(around(boxes), boxes),
            0.5 * (around(boxes).low + around(boxes).high));
}

TEST(CoordinateCenter, IsAmongMostWhereOneIsFarAway) {
  for (const double size : {0.01, 1.0, 1e6}) {
    const std::array boxes{cube({1e7, 0, 0}, size), cube({0, 0, 0}, 40.0), cube({1, 0, 0}, 1.0)};
    EXPECT_LT(glm::length(coordinate_center(around(boxes), boxes)), 2.0) << size;
  }
}

}  // namespace
}  // namespace brume
