// The stages of a frame are decided by scene and settings alone.

#include "render/render_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/renderer.h"
#include "tests/render/plan_cases.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/measure/plan_decisions.h"

namespace brume {
namespace {

using Method = AirlightMethod;
using Transfer = Surface::Transfer;

RenderPlan plan_of(const PlanCase& c) {
  const Scene scene = c.scene();
  return {scene, scene.film, c.settings()};
}

using Part = PlanCase::Part;

struct PlanExample {
  const char* what;
  PlanCase scene;
  const char* stages;
  const char* parts;
  const char* skipped;
};

// The order of stages and the words. PlanDecisions show that each stage is rightly left out.
const PlanExample plan_examples[] = {
    {"nothing",
     {},
     "prepare composite",
     "",
     "visibility: the scene has no surfaces\n"
     "transfer: no surface requests it\n"
     "environment: the scene has none\n"
     "light_depth: nothing emits light\n"
     "eye_depth: nothing emits light\n"
     "homogeneous: the medium's homogeneous density is 0\n"
     "noise: the medium has no Gaussians\n"
     "airlight: the medium is empty\n"},
    {"lit Gaussians of all orders, with surfaces that request transfer",
     {.lights = Part::active,
      .gaussians = Part::active,
      .noise = true,
      .surfaces = true,
      .transfer = Transfer::interreflection,
      .method = Method::sliced,
      .scattering = Scattering::multiple},
     "prepare visibility light_table scattering shadow_map airlight surfaces composite",
     "noise surface_scattering",
     "transfer: it is part of all orders of scattering\n"
     "environment: the scene has none\n"
     "homogeneous: the medium's homogeneous density is 0\n"},
    {"surfaces that request shadows, under a sky in fog",
     {.sky = Part::active,
      .fog = true,
      .surfaces = true,
      .transfer = Transfer::shadow,
      .method = Method::sliced},
     "transfer prepare visibility environment airlight surfaces composite",
     "homogeneous surface_scattering vertex_light",
     "light_table: nothing emits light\n"
     "shadow_map: nothing emits light\n"
     "noise: the medium has no Gaussians\n"},
    {"paths",
     {.lights = Part::active,
      .fog = true,
      .surfaces = true,
      .transfer = Transfer::shadow,
      .method = Method::path,
      .scale = 4},
     "prepare visibility paths composite",
     "homogeneous",
     "transfer: paths carry its light\n"
     "environment: the scene has none\n"
     "noise: the medium has no Gaussians\n"},
};

TEST(RenderPlan, RunsWhatScenesNeedAndSaysWhatTheyDoNot) {
  for (const PlanExample& example : plan_examples) {
    SCOPED_TRACE(example.what);
    const RenderPlan plan = plan_of(example.scene);
    EXPECT_EQ(to_string(plan.stages), example.stages);
    EXPECT_EQ(to_string(plan.parts), example.parts);
    EXPECT_EQ(in_words(plan.skipped), example.skipped);
    EXPECT_TRUE(plan.on_cpu.empty());
  }
}

// Lights that are off, black skies and Gaussians of no density.
TEST(RenderPlan, TakesPartsWithoutEffectAsMissing) {
  for (const PlanCase& c :
       few_plan_cases({Method::paper, Method::sliced, Method::reference, Method::path})) {
    const RenderPlan whole = plan_of(c);
    for (const SkippedStage& skipped : whole.skipped) ASSERT_FALSE(whole.runs(skipped.stage));
    for (Part PlanCase::*part : {&PlanCase::lights, &PlanCase::sky, &PlanCase::gaussians}) {
      PlanCase missing = c;
      missing.*part = Part::none;
      PlanCase idle = c;
      idle.*part = Part::idle;
      const RenderPlan expected = plan_of(missing);
      const RenderPlan plan = plan_of(idle);
      ASSERT_EQ(to_string(plan.stages), to_string(expected.stages)) << idle.name();
      ASSERT_EQ(to_string(plan.parts), to_string(expected.parts)) << idle.name();
    }
  }
}

TEST(RenderPlan, RasterizesWherePixelsOutnumberTriangles) {
  Scene scene;
  scene.surfaces = {wall(0.0, 1.0), wall(1.0, 1.0)};
  EXPECT_TRUE(RenderPlan(scene, {2, 2}, {}).rasterizes);
  EXPECT_FALSE(RenderPlan(scene, {3, 1}, {}).rasterizes);
  scene.surfaces.clear();
  EXPECT_FALSE(RenderPlan(scene, {2, 2}, {}).rasterizes);
}

TEST(RenderPlan, LeavesMoreThanOneScatteringOutOfThinMedia) {
  Settings settings;
  settings.scattering = Scattering::multiple;
  const auto plan_of_depth = [&](double depth) {
    Scene scene;
    scene.medium.append({{0, 0, 0}, 1.0, depth / std::sqrt(std::numbers::pi)});
    scene.lights.emplace_back();
    return RenderPlan(scene, {4, 4}, settings);
  };
  EXPECT_TRUE(plan_of_depth(0.003).runs(Stage::scattering));
  const RenderPlan thin = plan_of_depth(0.001);
  EXPECT_FALSE(thin.runs(Stage::scattering));
  EXPECT_EQ(thin.skipped.back().stage, Stage::scattering);
  EXPECT_EQ(thin.skipped.back().why, to_string(Reason::thin_medium));
  settings.max_error = 0.001;
  EXPECT_TRUE(plan_of_depth(0.001).runs(Stage::scattering)) << "matters at the bound asked for";
}

TEST(RenderPlan, KeepsTheRequestedPrecision) {
  Settings settings;
  settings.precision = Settings::Precision::plain_double;
  settings.depth_error = 0.01;
  const RenderPlan plan(cloud_scene(3, 1.0), {4, 4}, settings);
  EXPECT_EQ(plan.precision, settings.precision);
  EXPECT_EQ(plan.depth_error, settings.depth_error);
  const RenderPlan reference(cloud_scene(3, 1.0), {4, 4}, reference_settings());
  EXPECT_EQ(reference.precision, Settings::Precision::plain_double);
  EXPECT_EQ(reference.depth_error, reference_depth_error);
}

TEST(RenderPlan, LimitsTheMemoryOfLightMaps) {
  Scene scene = cloud_scene(3, 1.0);
  scene.surfaces.push_back(wall(-1.0, 1.0));
  Settings settings = sliced_settings({}, 96);
  EXPECT_EQ(RenderPlan(scene, {4, 4}, settings).settings, settings);
  scene.lights.resize(1000, scene.lights[0]);
  EXPECT_EQ(RenderPlan(scene, {4, 4}, settings).settings,
            limit_light_map_memory(settings, 1000, true));
  for (Light& light : scene.lights) light.on = false;
  EXPECT_EQ(RenderPlan(scene, {4, 4}, settings).settings, settings) << "none is on";
}

TEST(RenderPlan, WaitsForSharedTransfer) {
  PlanCase c;
  c.surfaces = c.fog = true;
  c.lights = PlanCase::Part::active;
  c.transfer = Transfer::shadow;
  const Scene scene = c.scene();
  TransferStore shared;
  const RenderPlan pending(scene, scene.film, {}, &shared);
  EXPECT_FALSE(pending.runs(Stage::transfer));
  EXPECT_EQ(pending.skipped.back().stage, Stage::transfer);
  EXPECT_EQ(pending.skipped.back().why, to_string(Reason::transfer_pending));
  EXPECT_EQ(pending.transfers.size(), 1u);
  ASSERT_TRUE(shared.make(pending.transfers, {}));
  const RenderPlan made(scene, scene.film, {}, &shared);
  EXPECT_TRUE(made.runs(Stage::transfer));
  EXPECT_EQ(in_words(made.skipped), in_words(RenderPlan(scene, scene.film, {}).skipped));
}

TEST(RenderPlan, MatchesTheStatisticsOfFrames) {
  for (const PlanCase& c :
       few_plan_cases({Method::paper, Method::sliced, Method::reference, Method::path})) {
    const Scene scene = c.scene();
    const RenderPlan plan(scene, scene.film, c.settings());
    expect_planned(render_frame(scene, c.settings()).statistics, plan, c.name());
  }
}

// Each group runs all stages; their times are added up by stage.
TEST(RenderPlan, RaysAreCastAtHolesAndPanes) {
  Scene scene = cloud_scene(3, 1.0);
  scene.surfaces = {wall(0.0, 1.0)};
  scene.surfaces[0].material.type = Material::Type::metallic_roughness;
  MetallicRoughness& material = scene.surfaces[0].material.metallic_roughness;
  const auto plan = [&](const Settings& settings) {
    return RenderPlan(scene, scene.film, settings);
  };
  EXPECT_TRUE(plan(sliced(12)).rasterizes);
  material.alpha = AlphaMode::cutout;
  EXPECT_FALSE(plan(sliced(12)).rasterizes);
  EXPECT_FALSE(plan(sliced(12)).has_panes);
  material.alpha = AlphaMode::blend;
  EXPECT_FALSE(plan(sliced(12)).rasterizes);
  EXPECT_TRUE(plan(sliced(12)).has_panes);
  const auto is_named = [](const RenderPlan& of) {
    return std::ranges::any_of(of.skipped, [](const SkippedStage& skipped) {
      return skipped.why == to_string(Reason::panes_beyond_reference);
    });
  };
  EXPECT_TRUE(is_named(plan(reference_settings())));
  EXPECT_FALSE(is_named(plan(sliced(12))));
}

TEST(RenderPlan, IsSharedByAlbedoGroups) {
  Scene scene = on_film(cloud_scene(3, 1.0), {16, 12});
  scene.optics.albedo = {0.9, 0.5, 0.2};
  const RenderPlan plan(scene, scene.film, paper_settings);
  const FrameStatistics statistics = render_frame(scene, paper_settings).statistics;
  StageSet ran;
  for (const StageTime& stage : statistics.stages) ran.add(stage.stage);
  EXPECT_EQ(to_string(ran), to_string(plan.stages));
  EXPECT_EQ(statistics.stages.size(), 5u) << to_string(ran);
  EXPECT_EQ(in_words(statistics.skipped), in_words(plan.skipped));
}

// Names that other programs read: each its own.
TEST(Stage, HasANameOfItsOwn) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < stage_count; ++i) {
    names.emplace_back(to_string(static_cast<Stage>(i)));
    EXPECT_FALSE(names.back().empty()) << i;
  }
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

// A plan may leave stages out, and where one is needed it is there.

class PlanDecisions : public testing::TestWithParam<PlanDecision> {};

TEST_P(PlanDecisions, LeaveOutNothingThatIsSeen) {
  const PlanDecision& decision = GetParam();
  const Frame left_out = render_planned(decision.left_out, decision.method);
  const Frame made = render_planned(decision.made, decision.method);
  const Frame needed = render_planned(decision.needed, decision.method);

  const auto is_left_out = [&](const Frame& frame) {
    return std::ranges::any_of(frame.statistics.skipped, [&](const SkippedStage& skipped) {
      return skipped.stage == decision.stage;
    });
  };
  ASSERT_TRUE(is_left_out(left_out));
  EXPECT_FALSE(is_left_out(made));
  EXPECT_FALSE(is_left_out(needed));
  bool why_is_said = false;
  for (const SkippedStage& skipped : left_out.statistics.skipped) {
    why_is_said |= skipped.stage == decision.stage && skipped.why == decision.why;
  }
  EXPECT_TRUE(why_is_said);

  // A billionth of it, and what single precision and light tables of other bounds make of the rest.
  EXPECT_LT(max_change(left_out, made, needed), 2e-3);
  EXPECT_GT(max_change(left_out, needed, needed), 2e-2);
}

INSTANTIATE_TEST_SUITE_P(All, PlanDecisions, testing::ValuesIn(plan_decisions()),
                         [](const auto& instance) {
                           return std::string(to_string(instance.param.stage));
                         });

// No decision is missing here: all that plans of empty and of dark scenes leave out has its own.
TEST(PlanDecision, EachHasItsScenes) {
  StageSet known;
  for (const PlanDecision& decision : plan_decisions()) known.add(decision.stage);
  for (const PlanDecision& decision : plan_decisions()) {
    for (const Scene* scene : {&decision.left_out, &decision.made, &decision.needed}) {
      for (const AirlightMethod method : {AirlightMethod::paper, AirlightMethod::sliced,
                                          AirlightMethod::reference, AirlightMethod::path}) {
        Settings settings;
        settings.airlight = method;
        for (const SkippedStage& skipped : RenderPlan(*scene, scene->film, settings).skipped) {
          EXPECT_TRUE(known.has(skipped.stage)) << to_string(skipped.stage);
        }
      }
    }
  }
}

}  // namespace

}  // namespace brume
