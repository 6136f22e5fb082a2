// Pixels of the device whose neighbours may differ: borders of tiles, the place of a
// light, and surfaces seen edge-on.

#include <cmath>

#include "core/scene/camera_rays.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/seams.h"
#include "tests/render/test_scenes.h"
#include "tests/render/visibility/box_on_floor.h"

namespace brume::gl {
namespace {

// See TileSeams of test_render.
TEST_F(GlFrames, StepNoMoreAtBordersOfTilesThanWithin) {
  Seams seams;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Scene scene = seam_scene(seed);
    Settings settings = sliced_settings({}, 8);
    settings.airlight_scale = 4;
    const std::string name = "seed " + std::to_string(seed);
    seams.add(find_seams(render_on_device(scene, settings, name),
                         render_frame(scene, sliced_settings({}, 64)), 4));
  }
  EXPECT_LT(seams.ratio(0.75), 2.5);
  EXPECT_LT(seams.ratio(0.9), 2.5);
}

// A light in a Gaussian smaller than samples are apart.
TEST_F(GlFrames, ComputePixelsNearestToALight) {
  Scene scene = seen_by({{0.0, 0.0, 4.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 40.0}, {61, 40});
  const CameraRays rays(scene.camera, scene.film);
  scene.lights.push_back(
      {scene.camera.eye + 4.0 * rays.direction(30.5, 22.5), glm::dvec3(10.0), {}});
  scene.medium.append({scene.lights[0].position, 0.02, 1.0});
  Settings settings = sliced_settings({}, 64);
  const Frame full = render_frame(scene, settings);
  for (const int scale : {2, 4}) {
    settings.airlight_scale = scale;
    const Frame frame = render_on_device(scene, settings, "scale " + std::to_string(scale));
    EXPECT_LT(rel_rmse(frame.airlight, full.airlight), 0.02) << scale;
  }
}

// A wall whose plane the eye lies in, but for a rounding: see EdgeOn of test_render.
TEST_F(GlFrames, HideTrianglesSeenEdgeOn) {
  for (const double off : {0.0, 1e-9, -2e-8}) {
    for (const glm::dvec3& eye : {glm::dvec3(0.3, 0.7, off), glm::dvec3(4.0, 3.0, off)}) {
      Scene scene = cloud_scene(3, 1.0);
      scene.surfaces.push_back(wall(0.0, 2.0));
      scene.camera.eye = eye;
      scene.camera.target = {0.1, 0.0, 0.0};
      const Frame frame = render_on_device(scene, quick_slices(), "edge on");
      for (const float t : frame.depth) ASSERT_TRUE(std::isinf(t));
    }
  }
}

// See ShadowMargins of test_render.
TEST_F(GlFrames, KeepShadowsOnFloorsOfAnySize) {
  const auto floor = [](double size) {
    return primitive_surface(Primitive::Shape::plane, {size, 1, size}, {});
  };
  for (const Light& light : {oblique_sun(), light_beside_box(1.0)}) {
    const Frame expected = render_frame(box_on_floor(floor(40.0), light), quick_slices());
    for (const Surface& large : {floor(1e4), floor(1e7), two_triangles(1e5), two_triangles(1e7)}) {
      const Frame frame =
          render_on_device(box_on_floor(large, light), quick_slices(), "box on a floor");
      EXPECT_LT(rel_rmse(frame.beauty, expected.beauty), 1e-3);
    }
  }
}

TEST_F(GlFrames, LeaveClosedRoomsDark) {
  const Frame frame = render_on_device(closed_room(1e4), quick_slices(), "closed room");
  for (std::size_t i = 0; i < frame.depth.size(); ++i) ASSERT_EQ(frame.beauty[4 * i], 0.0f);
}

}  // namespace
}  // namespace brume::gl
