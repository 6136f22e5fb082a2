// Surfaces that emit, as lights of every method but `paper`.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "brume/frame.h"
#include "tests/render/paths/traced_scene.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

const glm::dvec3 bar_radiance(8.0, 4.0, 2.0);

// A bar above a floor, in thin fog; black but for what it emits.
Scene bar_in_fog() {
  Scene scene = seen_by({.eye = {0.0, 1.2, 5.0}, .target = {0.0, 0.7, 0.0}}, {24, 18});
  scene.optics.albedo = glm::dvec3(0.9);
  scene.surfaces = {placed(Primitive::Shape::plane, {8.0, 1.0, 8.0}, {0.0, 0.0, 0.0}),
                    placed(Primitive::Shape::box, {1.6, 0.2, 0.2}, {0.0, 1.2, -0.5})};
  scene.surfaces[1].material = metallic_roughness(glm::dvec3(0.0), 0.0, 1.0, bar_radiance);
  return in_fog(scene, 0.05);
}

// The same light of rectangles on its sides.
Scene rectangles_in_fog() {
  Scene scene = bar_in_fog();
  const Surface& bar = scene.surfaces[1];
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      glm::dvec3 normal(0.0);
      glm::dvec3 up(0.0);
      normal[axis] = side;
      up[(axis + 2) % 3] = 1.0;
      Light light{.position = bar.translate + 0.5005 * bar.primitive->size * normal,
                  .intensity = bar_radiance};
      light.kind = light::Rectangle{.direction = normal,
                                    .up = up,
                                    .width = bar.primitive->size[(axis + 1) % 3],
                                    .height = bar.primitive->size[(axis + 2) % 3]};
      scene.lights.push_back(light);
    }
  }
  scene.surfaces[1].material.metallic_roughness.emissive = glm::dvec3(0.0);
  return scene;
}

double sum(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(EmittingSurfacesInFog, LightItAsRectanglesOnTheirSidesDo) {
  const Settings settings = all_orders(24);
  const Frame bar = render_frame(bar_in_fog(), settings);
  const Frame rectangles = render_frame(rectangles_in_fog(), settings);
  EXPECT_GT(sum(bar.airlight), 0.0);
  EXPECT_NEAR(sum(bar.airlight) / sum(rectangles.airlight), 1.0, 0.03);
}

// A hand's breadth above the floor, of which no pixel shows the points.
TEST(EmittingSurfacesInFog, LightAFloorNextToThemAsRectanglesDo) {
  const auto on_floor = [](Scene scene) {
    const double down = 1.06;
    scene.surfaces[1].translate.y -= down;
    for (Light& light : scene.lights) light.position.y -= down;
    scene.camera = {.eye = {0.0, 1.2, 1.0}, .target = {0.0, 0.0, 0.0}};
    scene.surfaces[0].material.reflectance = glm::dvec3(0.5);
    return render_frame(in_fog(scene, 0.0), sliced(8));
  };
  const Frame bar = on_floor(bar_in_fog());
  const Frame rectangles = on_floor(rectangles_in_fog());
  ASSERT_EQ(bar.beauty.size(), rectangles.beauty.size());
  for (std::size_t i = 0; i < bar.beauty.size(); ++i) {
    if (rectangles.beauty[i] == 0.0f) continue;  // the bar itself
    EXPECT_NEAR(bar.beauty[i] / rectangles.beauty[i], 1.0, 0.03) << i / 4;
  }
}

// Collisions alone find the light nearby: twice the noise of rectangles, not all of it.
TEST(EmittingSurfacesInFog, PathsFindThemAsTheyFindRectangles) {
  const TracedScene bar(bar_in_fog(), 0.9);
  const TracedScene rectangles(rectangles_in_fog(), 0.9);
  const glm::dvec3 eye(0.0, 1.2, 5.0);
  for (const glm::dvec3& target : {glm::dvec3(0.9, 1.0, -0.5), glm::dvec3(0.0, 1.6, -0.5)}) {
    const auto a = bar.airlight(eye, target, 512 * path_block).sum;
    const auto b = rectangles.airlight(eye, target, 512 * path_block).sum;
    EXPECT_NEAR(a.mean.x, b.mean.x, 4.0 * std::hypot(a.error.x, b.error.x));
    EXPECT_LT(a.error.x, 4.0 * b.error.x) << a.mean.x << " " << b.mean.x;
  }
  const glm::dvec3 floor(0.3, 0.0, 0.4);
  const auto a = bar.surface(eye, floor, 512 * path_block).sum;
  const auto b = rectangles.surface(eye, floor, 512 * path_block).sum;
  EXPECT_NEAR(a.mean.y, b.mean.y, 4.0 * std::hypot(a.error.y, b.error.y));
  EXPECT_LT(a.error.y, 4.0 * b.error.y) << a.mean.y << " " << b.mean.y;
}

TEST(EmittingSurfacesInFog, AreLeftOutByThePapersMethodWhichSaysSo) {
  const Frame frame = render_frame(bar_in_fog(), paper_settings);
  EXPECT_EQ(sum(frame.airlight), 0.0);
  EXPECT_TRUE(std::ranges::any_of(frame.statistics.skipped, [](const SkippedStage& skipped) {
    return skipped.stage == Stage::lights;
  }));
}

// Both halves of the balance heuristic, without lights.
TEST(EmittingSurfacesInFog, AreAWhiteFurnaceFromWithin) {
  Scene scene = bar_in_fog();
  scene.optics.albedo = glm::dvec3(1.0);
  scene.surfaces = {placed(Primitive::Shape::box, {4.0, 4.0, 4.0}, {0.0, 0.0, 0.0})};
  // Reflects only what Schlick's term adds.
  scene.surfaces[0].material = metallic_roughness(glm::dvec3(0.0), 1.0, 1.0, glm::dvec3(1.0));
  const TracedScene room(in_fog(scene, 0.5), 1.0);
  // Radiance is the same everywhere where walls send 1 and reflect next to nothing.
  const auto radiance = room.airlight({0.0, 0.0, 0.0}, {2.0, 0.3, 0.1}, 128 * path_block).sum;
  const double opacity = 1.0 - std::exp(-0.5 * 2.0 * std::sqrt(1.0 + 0.15 * 0.15 + 0.05 * 0.05));
  EXPECT_NEAR(radiance.mean.x, opacity, 0.05 * opacity + 4.0 * radiance.error.x);
}

}  // namespace
}  // namespace brume
