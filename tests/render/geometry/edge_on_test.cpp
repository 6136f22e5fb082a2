// Surfaces whose plane the eye lies in.

#include "render/geometry/edge_on.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brume/mesh_arrays.h"
#include "render/quality/auto_quality.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// A floor at y = 0 of cells x cells squares, 2 u to each side.
Surface make_floor(int cells) {
  MeshArrays mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const auto x = 4.0f * static_cast<float>(j) / static_cast<float>(cells) - 2.0f;
      const auto z = 4.0f * static_cast<float>(i) / static_cast<float>(cells) - 2.0f;
      mesh.points.emplace_back(x, 0.0f, z);
      mesh.normals.emplace_back(0, 1, 0);
    }
  }
  const auto at = [&](int i, int j) { return static_cast<unsigned>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  Surface surface;
  surface.mesh = to_mesh(mesh);
  return surface;
}

// Fog over a floor, seen by an eye in its plane but for `off`.
Scene on_the_floor(const glm::dvec3& eye, const glm::dvec3& target, double off, int cells) {
  Scene scene = cloud_scene(10, 1.0);
  scene.camera.eye = eye + glm::dvec3(0.0, off, 0.0);
  scene.camera.target = target;
  scene.film = {32, 25};
  scene.surfaces.push_back(make_floor(cells));
  return scene;
}

std::size_t hits(const Frame& frame) {
  return static_cast<std::size_t>(
      std::ranges::count_if(frame.depth, [](float t) { return std::isfinite(t); }));
}

// From next to the floor and on it, ahead, askew, up and down; few triangles are rasterized, many
// hit by rays.
TEST(EdgeOn, PlanesThroughTheEyeAreInvisible) {
  for (const int cells : {1, 3, 30}) {
    for (const glm::dvec3& eye :
         {glm::dvec3(0, 0, 5), glm::dvec3(3, 0, 4), glm::dvec3(0.3, 0, 0.7)}) {
      for (const double target : {0.0, 0.3, -0.4}) {
        for (const double off : {0.0, 1e-9, -2e-8}) {
          SCOPED_TRACE(testing::Message() << cells << " cells, eye at " << eye.x << ' ' << eye.z
                                          << ", target " << target << ", off by " << off);
          const Scene scene = on_the_floor(eye, {0.1, target, 0.0}, off, cells);
          EXPECT_EQ(hits(render_frame(scene, sliced_settings({}, 8))), 0U);
        }
      }
    }
  }
}

TEST(EdgeOn, PlanesJustBelowTheEyeAreVisible) {
  const Scene scene = on_the_floor({0.3, 0.0, 0.7}, {0.1, 0.0, 0.0}, 1e-3, 3);
  EXPECT_GT(hits(render_frame(scene, sliced_settings({}, 8))), 32U * 12U);
}

TEST(EdgeOn, MethodsAndTheErrorAgree) {
  for (const double off : {0.0, 1e-9}) {
    const Scene scene = on_the_floor({0, 0, 5}, {0, 0, 0}, off, 3);
    Settings reference_settings;
    reference_settings.airlight = AirlightMethod::reference;
    const Frame reference = render_frame(scene, reference_settings);
    const Frame frame = render_frame(scene, sliced_settings({}, 32));
    EXPECT_EQ(hits(reference), 0U);
    EXPECT_LT(rel_rmse(frame.airlight, reference.airlight), 0.02);
    const auto error = measure_error(scene, scene.camera, frame);
    ASSERT_TRUE(error);
    EXPECT_LT(error->airlight.high, 0.05);
  }
}

TEST(EdgeOn, TrianglesWithoutAnAreaAlwaysAre) {
  EXPECT_TRUE(is_edge_on({glm::vec3(0.0f), glm::vec3(1.0f), glm::vec3(2.0f)}, {0, 5, 0}));
  EXPECT_FALSE(is_edge_on({glm::vec3(0.0f), {1, 0, 0}, {0, 0, 1}}, {0, 5, 0}));
  EXPECT_FALSE(is_edge_on({glm::vec3(0.0f), {1, 0, 0}, {0, 0, 1}}, {0, 1e-7, 0}));
  EXPECT_TRUE(is_edge_on({glm::vec3(0.0f), {1, 0, 0}, {0, 0, 1}}, {9, 2e-7, 9}));
}

}  // namespace
}  // namespace brume
