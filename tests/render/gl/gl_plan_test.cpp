// What runs on the device is decided without one.

#include "render/gl/gl_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

GlPlan plan_of(const Scene& scene, const Settings& settings) {
  return {settings, RenderPlan(scene, settings.airlight)};
}

bool has(const GlPlan& plan, const char* stage) {
  return std::ranges::any_of(plan.on_cpu,
                             [&](const SkippedStage& known) { return known.stage == stage; });
}

TEST(GlPlan, LeavesTheCpuWhatOnlyItCan) {
  const Scene scene = cloud_scene(3, 1.0);
  Settings settings = sliced_settings({}, 24);
  EXPECT_EQ(plan_of(scene, settings).refusal, "");
  EXPECT_TRUE(plan_of(scene, settings).on_cpu.empty());
  settings.airlight = AirlightMethod::paper;
  EXPECT_EQ(plan_of(scene, settings).refusal, "");
  EXPECT_TRUE(has(plan_of(scene, settings), "eye_depth"));
  settings.precision = Settings::Precision::plain_double;
  EXPECT_NE(plan_of(scene, settings).refusal, "");
  for (const AirlightMethod method : {AirlightMethod::march, AirlightMethod::reference}) {
    settings = {};
    settings.airlight = method;
    EXPECT_NE(plan_of(scene, settings).refusal.find(to_string(method)), std::string::npos);
    EXPECT_TRUE(has(plan_of(scene, settings), "frame"));
  }
}

TEST(GlPlan, RefusesTooManySlices) {
  Scene scene = cloud_scene(3, 1.0);
  EXPECT_EQ(plan_of(scene, sliced_settings({}, 256)).refusal, "");
  EXPECT_NE(plan_of(scene, sliced_settings({}, 257)).refusal, "");
  // Many lights share what room there is.
  scene.lights.resize(100, scene.lights[0]);
  EXPECT_EQ(plan_of(scene, sliced_settings({}, 96)).refusal, "");
}

TEST(GlPlan, ListsWhatSurfacesAndEnvironmentsNeed) {
  Scene scene = cloud_scene(3, 1.0);
  scene.surfaces.push_back(wall(-1.0, 1.0));
  const GlPlan plan = plan_of(scene, sliced_settings({}, 12));
  EXPECT_FALSE(has(plan, "visibility"));
  EXPECT_FALSE(has(plan, "shadow_map"));
  EXPECT_FALSE(has(plan, "surfaces"));
  EXPECT_FALSE(has(plan, "environment"));
  scene.surfaces[0].transfer = Surface::Transfer::shadow;
  EXPECT_TRUE(has(plan_of(scene, sliced_settings({}, 12)), "vertex_light"));
  scene.environment.emplace();
  scene.environment->map = constant_sky(1.0f);
  EXPECT_TRUE(has(plan_of(scene, sliced_settings({}, 12)), "environment"));
  EXPECT_FALSE(has(plan_of(scene, paper_settings), "environment"));
  EXPECT_TRUE(has(plan_of(scene, paper_settings), "average_depth"));
}

}  // namespace
}  // namespace brume::gl
