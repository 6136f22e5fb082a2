// The stages of the device are decided without one.

#include "render/gl/gl_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/contains.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/plan_cases.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

RenderPlan plan_of(const Scene& scene, const Settings& settings,
                   const DisplayOptions* display = nullptr) {
  return device_plan(RenderPlan(scene, scene.film, settings), display);
}

std::optional<Reason> refusal_of(const Scene& scene, const Settings& settings) {
  return refusal(RenderPlan(scene, scene.film, settings));
}

bool is_on_cpu(const RenderPlan& plan, Stage stage) {
  return std::ranges::find(plan.on_cpu, stage, &SkippedStage::stage) != plan.on_cpu.end();
}

TEST(GlPlan, LeavesTheCpuWhatOnlyItCan) {
  const Scene scene = cloud_scene(3, 1.0);
  Settings settings = sliced_settings({}, 24);
  EXPECT_EQ(refusal_of(scene, settings), std::nullopt);
  EXPECT_TRUE(plan_of(scene, settings).on_cpu.empty());
  settings.airlight = AirlightMethod::paper;
  EXPECT_EQ(refusal_of(scene, settings), std::nullopt);
  EXPECT_TRUE(is_on_cpu(plan_of(scene, settings), Stage::eye_depth));
  settings.precision = Settings::Precision::plain_double;
  EXPECT_EQ(refusal_of(scene, settings), Reason::double_precision);
  for (const AirlightMethod method : {AirlightMethod::reference, AirlightMethod::path}) {
    settings = {};
    settings.airlight = method;
    const std::optional<Reason> reason = refusal_of(scene, settings);
    ASSERT_TRUE(reason);
    EXPECT_TRUE(contains(to_string(*reason), to_string(method)));
  }
}

TEST(GlPlan, RefusesHolesAndPanes) {
  Scene scene = cloud_scene(3, 1.0);
  scene.surfaces = {wall(0.0, 1.0)};
  Material& material = scene.surfaces[0].material;
  material.type = Material::Type::metallic_roughness;
  const Settings settings = sliced_settings({}, 24);
  EXPECT_EQ(refusal_of(scene, settings), std::nullopt);
  material.metallic_roughness.alpha = AlphaMode::cutout;
  EXPECT_EQ(refusal_of(scene, settings), Reason::coverage_on_cpu);
  material.metallic_roughness.alpha = AlphaMode::blend;
  EXPECT_EQ(refusal_of(scene, settings), Reason::coverage_on_cpu);
  material.metallic_roughness.alpha = AlphaMode::opaque;
  material.metallic_roughness.transmission.y = 0.1;
  EXPECT_EQ(refusal_of(scene, settings), Reason::coverage_on_cpu);
}

TEST(GlPlan, RefusesCopies) {
  Scene scene = cloud_scene(3, 1.0);
  scene.surfaces = {wall(0.0, 1.0)};
  scene.surfaces[0].placed_copies = std::make_shared<const CopyPlacements>(1);
  EXPECT_EQ(refusal_of(scene, sliced_settings({}, 24)), Reason::copies_on_cpu);
}

TEST(GlPlan, RefusesVisibleLights) {
  Scene scene = cloud_scene(3, 1.0);
  scene.lights[0].kind = light::Sphere{};
  EXPECT_EQ(refusal_of(scene, sliced_settings({}, 24)), std::nullopt);
  scene.lights[0].kind = light::Sphere{.visible = true};
  EXPECT_EQ(refusal_of(scene, sliced_settings({}, 24)), Reason::visible_lights_on_cpu);
}

TEST(GlPlan, RefusesTooManySlices) {
  Scene scene = cloud_scene(3, 1.0);
  EXPECT_EQ(refusal_of(scene, sliced_settings({}, 256)), std::nullopt);
  EXPECT_EQ(refusal_of(scene, sliced_settings({}, 257)), Reason::too_many_slices);
  // Many lights share what room there is.
  scene.lights.resize(100, scene.lights[0]);
  EXPECT_EQ(refusal_of(scene, sliced_settings({}, 96)), std::nullopt);
}

TEST(GlPlan, RefusesTooManyRadii) {
  const Scene scene = cloud_scene(3, 1.0);
  Settings settings = sliced_settings({}, 24);
  settings.optical_depth_table.radii = 1024;
  EXPECT_EQ(refusal_of(scene, settings), std::nullopt);
  settings.optical_depth_table.radii = 1025;
  EXPECT_EQ(refusal_of(scene, settings), Reason::too_many_radii);
  settings.airlight = AirlightMethod::paper;
  EXPECT_EQ(refusal_of(scene, settings), std::nullopt);
}

TEST(GlPlan, ListsWhatSurfacesAndEnvironmentsNeed) {
  Scene scene = cloud_scene(3, 1.0);
  scene.surfaces.push_back(wall(-1.0, 1.0));
  EXPECT_TRUE(plan_of(scene, sliced_settings({}, 12)).on_cpu.empty());
  scene.surfaces[0].transfer = Surface::Transfer::shadow;
  EXPECT_TRUE(is_on_cpu(plan_of(scene, sliced_settings({}, 12)), Stage::vertex_light));
  scene.environment.emplace();
  scene.environment->map = constant_sky(1.0f);
  EXPECT_TRUE(is_on_cpu(plan_of(scene, sliced_settings({}, 12)), Stage::environment));
  EXPECT_FALSE(is_on_cpu(plan_of(scene, paper_settings), Stage::environment));
  EXPECT_TRUE(is_on_cpu(plan_of(scene, paper_settings), Stage::average_depth));
}

// Only what a frame is for leaves the device.
TEST(GlPlan, ReadsBackWhatIsNotDisplayed) {
  Scene scene = cloud_scene(3, 1.0);
  const DisplayOptions picture;
  const DisplayOptions with_depth{.depth = true};
  const auto stages = [&](const DisplayOptions* display) {
    return plan_of(scene, sliced_settings({}, 12), display).stages;
  };
  EXPECT_TRUE(stages(nullptr).has(Stage::read_back));
  EXPECT_FALSE(stages(nullptr).has(Stage::display));
  EXPECT_FALSE(stages(&picture).has(Stage::read_back));
  EXPECT_TRUE(stages(&picture).has(Stage::display));
  EXPECT_FALSE(stages(&with_depth).has(Stage::read_depth)) << "there are no surfaces";
  scene.surfaces.push_back(wall(-1.0, 1.0));
  EXPECT_TRUE(stages(&with_depth).has(Stage::read_depth));
  EXPECT_FALSE(stages(&picture).has(Stage::read_depth));
}

using GlPlanOfFrames = GlFrames;

TEST_F(GlPlanOfFrames, MatchesTheirStatistics) {
  for (const PlanCase& c : few_plan_cases({AirlightMethod::paper, AirlightMethod::sliced})) {
    const Scene scene = c.scene();
    const RenderPlan plan = plan_of(scene, c.settings());
    expect_planned(render(scene, c.settings()).statistics, plan, c.name());
  }
}

}  // namespace
}  // namespace brume::gl
