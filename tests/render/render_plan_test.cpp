// What a frame computes, decided by scene and settings alone: each stage runs if and only if its
// rule says so, in every combination of what a scene may have.

#include "render/render_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "render/renderer.h"
#include "tests/render/plan_cases.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

using Method = AirlightMethod;
using Transfer = Surface::Transfer;
using SurfaceDepths = RenderPlan::SurfaceDepths;

RenderPlan plan_of(const PlanCase& c) {
  const Scene scene = c.scene();
  return {scene, scene.film, c.settings()};
}

// What surfaces take from all directions by other means than paths.
bool has_indirect_light(const PlanCase& c) {
  return !c.is(Method::path) && (c.has_sky() || (c.has_lights() && c.has_medium()));
}

bool has_all_orders(const PlanCase& c) {
  return c.is_multiple() && c.has_any_light() && c.has_medium();
}

bool uses_transfer(const PlanCase& c) {
  if (has_all_orders(c)) return false;
  return (c.transfer == Transfer::shadow && has_indirect_light(c)) ||
         (c.transfer == Transfer::interreflection && c.has_any_light() && !c.is(Method::path));
}

struct StageRule {
  Stage stage;
  bool (*runs)(const PlanCase& c);
};

const StageRule stage_rules[] = {
    {Stage::transfer, uses_transfer},
    {Stage::prepare, [](const PlanCase&) { return true; }},
    {Stage::visibility, [](const PlanCase& c) { return c.surfaces; }},
    {Stage::environment,
     [](const PlanCase& c) {
       return c.has_sky() && c.has_medium() && !c.is(Method::paper) && !c.is(Method::path) &&
              (!c.is(Method::reference) || c.surfaces);
     }},
    {Stage::light_depth,
     [](const PlanCase& c) { return c.is(Method::paper) && c.has_lights() && c.has_gaussians(); }},
    {Stage::eye_depth,
     [](const PlanCase& c) { return c.is(Method::paper) && c.has_lights() && c.has_gaussians(); }},
    {Stage::light_table,
     [](const PlanCase& c) { return c.is(Method::sliced) && c.has_lights() && c.has_gaussians(); }},
    {Stage::scattering, has_all_orders},
    {Stage::shadow_map,
     [](const PlanCase& c) {
       return c.is(Method::sliced) && c.has_lights() && c.has_medium() && c.surfaces;
     }},
    {Stage::airlight,
     [](const PlanCase& c) { return c.has_medium() && c.has_any_light() && !c.is(Method::path); }},
    {Stage::paths,
     [](const PlanCase& c) {
       return c.is(Method::path) && c.has_any_light() && (c.has_medium() || c.surfaces);
     }},
    {Stage::transmittance, [](const PlanCase& c) { return c.has_medium() && !c.has_any_light(); }},
    {Stage::surfaces,
     [](const PlanCase& c) { return c.surfaces && c.has_any_light() && !c.is(Method::path); }},
    {Stage::composite, [](const PlanCase&) { return true; }},
};

const StageRule part_rules[] = {
    {Stage::homogeneous, [](const PlanCase& c) { return c.fog; }},
    {Stage::noise, [](const PlanCase& c) { return c.noise && c.has_gaussians(); }},
    {Stage::upsample,
     [](const PlanCase& c) { return c.has_medium() && c.scale > 1 && !c.is(Method::path); }},
    {Stage::average_depth,
     [](const PlanCase& c) {
       return c.is(Method::paper) && c.surfaces && c.has_sky() && c.has_gaussians();
     }},
    {Stage::surface_scattering,
     [](const PlanCase& c) {
       return c.surfaces && c.has_any_light() && c.has_medium() && !c.is(Method::path);
     }},
    {Stage::vertex_light, uses_transfer},
};

StageSet expected(std::span<const StageRule> rules, const PlanCase& c) {
  StageSet stages;
  for (const StageRule& rule : rules) stages.add(rule.stage, rule.runs(c));
  return stages;
}

TEST(RenderPlan, RunsStagesByTheirRules) {
  ASSERT_EQ(all_plan_cases().size(), 4u * 27u * 4u * 20u);
  for (const PlanCase& c : all_plan_cases()) {
    const RenderPlan plan = plan_of(c);
    ASSERT_EQ(to_string(plan.stages), to_string(expected(stage_rules, c))) << c.name();
    ASSERT_EQ(to_string(plan.parts), to_string(expected(part_rules, c))) << c.name();
    ASSERT_TRUE(plan.on_cpu.empty());
  }
}

struct SkipRule {
  Stage stage;
  Reason why;
  bool (*is_skipped)(const PlanCase& c);
  std::size_t count = 0;
};

const SkipRule skip_rules[] = {
    {Stage::visibility, Reason::no_surfaces, [](const PlanCase& c) { return !c.surfaces; }},
    {Stage::surfaces, Reason::no_light,
     [](const PlanCase& c) { return c.surfaces && !c.has_any_light(); }},
    {Stage::transfer, Reason::no_transfer_requested,
     [](const PlanCase& c) { return c.transfer == Transfer::none; }},
    {Stage::transfer, Reason::no_light,
     [](const PlanCase& c) { return c.transfer != Transfer::none && !c.has_any_light(); }},
    {Stage::transfer, Reason::only_direct_light,
     [](const PlanCase& c) {
       return c.transfer == Transfer::shadow && c.has_lights() && !c.has_sky() && !c.has_medium() &&
              !c.is(Method::path);
     }},
    {Stage::transfer, Reason::part_of_paths,
     [](const PlanCase& c) {
       return c.transfer != Transfer::none && c.has_any_light() && c.is(Method::path);
     }},
    {Stage::transfer, Reason::part_of_all_orders,
     [](const PlanCase& c) { return c.transfer != Transfer::none && has_all_orders(c); }},
    {Stage::surface_scattering, Reason::no_medium,
     [](const PlanCase& c) { return c.surfaces && c.has_any_light() && !c.has_medium(); }},
    {Stage::environment, Reason::no_environment,
     [](const PlanCase& c) { return c.sky == PlanCase::Part::none; }},
    {Stage::environment, Reason::black_environment,
     [](const PlanCase& c) { return c.sky == PlanCase::Part::idle; }},
    {Stage::light_depth, Reason::no_light,
     [](const PlanCase& c) { return c.is(Method::paper) && !c.has_lights(); }},
    {Stage::light_depth, Reason::no_gaussians,
     [](const PlanCase& c) { return c.is(Method::paper) && c.has_lights() && !c.has_gaussians(); }},
    {Stage::eye_depth, Reason::no_light,
     [](const PlanCase& c) { return c.is(Method::paper) && !c.has_lights(); }},
    {Stage::eye_depth, Reason::no_gaussians,
     [](const PlanCase& c) { return c.is(Method::paper) && c.has_lights() && !c.has_gaussians(); }},
    {Stage::light_table, Reason::no_light,
     [](const PlanCase& c) { return c.is(Method::sliced) && !c.has_lights(); }},
    {Stage::light_table, Reason::no_gaussians,
     [](const PlanCase& c) {
       return c.is(Method::sliced) && c.has_lights() && !c.has_gaussians();
     }},
    {Stage::shadow_map, Reason::no_surfaces,
     [](const PlanCase& c) { return c.is(Method::sliced) && !c.surfaces; }},
    {Stage::shadow_map, Reason::no_light,
     [](const PlanCase& c) { return c.is(Method::sliced) && c.surfaces && !c.has_lights(); }},
    {Stage::shadow_map, Reason::no_medium,
     [](const PlanCase& c) {
       return c.is(Method::sliced) && c.surfaces && c.has_lights() && !c.has_medium();
     }},
    {Stage::homogeneous, Reason::no_homogeneous_density, [](const PlanCase& c) { return !c.fog; }},
    {Stage::noise, Reason::no_gaussians, [](const PlanCase& c) { return !c.has_gaussians(); }},
    {Stage::noise, Reason::no_noise,
     [](const PlanCase& c) { return c.has_gaussians() && !c.noise; }},
    {Stage::airlight, Reason::no_medium, [](const PlanCase& c) { return !c.has_medium(); }},
    {Stage::airlight, Reason::no_light,
     [](const PlanCase& c) { return c.has_medium() && !c.has_any_light(); }},
    {Stage::lights, Reason::lights_off,
     [](const PlanCase& c) { return c.lights == PlanCase::Part::idle; }, 1},
    {Stage::lights, Reason::black_lights,
     [](const PlanCase& c) { return c.lights == PlanCase::Part::idle; }, 1},
    {Stage::scattering, Reason::no_light,
     [](const PlanCase& c) { return c.is_multiple() && !c.has_any_light(); }},
    {Stage::scattering, Reason::no_medium,
     [](const PlanCase& c) { return c.is_multiple() && c.has_any_light() && !c.has_medium(); }},
};

TEST(RenderPlan, SkipsStagesForTheirReasons) {
  for (const PlanCase& c : all_plan_cases()) {
    std::vector<SkippedStage> skipped;
    for (const SkipRule& rule : skip_rules) {
      if (rule.is_skipped(c)) skipped.push_back({rule.stage, to_string(rule.why, rule.count)});
    }
    ASSERT_EQ(in_words(plan_of(c).skipped), in_words(skipped)) << c.name();
  }
}

TEST(RenderPlan, ChoosesByItsRules) {
  for (const PlanCase& c : all_plan_cases()) {
    const RenderPlan plan = plan_of(c);
    const bool is_reference = c.is(Method::reference);
    ASSERT_EQ(plan.has_environment, c.has_sky()) << c.name();
    ASSERT_EQ(plan.has_environment_in_medium, c.has_sky() && c.has_medium()) << c.name();
    ASSERT_EQ(plan.has_receivers, c.has_sky() && c.has_medium() && c.surfaces &&
                                      !c.is(Method::paper) && !c.is(Method::path) &&
                                      !has_all_orders(c))
        << c.name();
    ASSERT_EQ(plan.has_all_light_at_surfaces, c.surfaces && has_all_orders(c)) << c.name();
    ASSERT_EQ(plan.has_indirect_light, has_indirect_light(c)) << c.name();
    const bool sums_depths = c.surfaces && c.has_lights() && c.has_gaussians();
    ASSERT_EQ(plan.surface_depths, !sums_depths || c.is(Method::path) ? SurfaceDepths::none
                                   : c.is(Method::sliced)             ? SurfaceDepths::tables
                                                                      : SurfaceDepths::exact)
        << c.name();
    ASSERT_EQ(plan.has_exact_occlusion, is_reference);
    ASSERT_EQ(plan.precision,
              is_reference ? Settings::Precision::plain_double : Settings::Precision::simd_float);
    ASSERT_EQ(plan.depth_error, is_reference         ? reference_depth_error
                                : c.is(Method::path) ? path_depth_error
                                                     : Settings{}.depth_error);
    ASSERT_EQ(plan.lights.size(), c.has_lights() ? 2u : 0u);
    ASSERT_EQ(plan.transfers.size(), uses_transfer(c) ? 1u : 0u);
    ASSERT_EQ(plan.transfers, needed_transfers(c.scene(), c.settings()));
    ASSERT_EQ(plan.has_medium(), c.has_medium());
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
  for (const PlanCase& c : few_plan_cases(
           {Method::paper, Method::sliced, Method::march, Method::reference, Method::path})) {
    const Scene scene = c.scene();
    const RenderPlan plan(scene, scene.film, c.settings());
    const FrameStatistics statistics = render_frame(scene, c.settings()).statistics;
    StageSet ran;
    for (const StageTime& stage : statistics.stages) {
      EXPECT_FALSE(ran.has(stage.stage)) << to_string(stage.stage) << " twice, " << c.name();
      ran.add(stage.stage);
    }
    EXPECT_EQ(to_string(ran), to_string(plan.stages)) << c.name();
    EXPECT_EQ(in_words(statistics.skipped), in_words(plan.skipped)) << c.name();
  }
}

// Each group runs all stages; their times are added up by stage.
TEST(RenderPlan, IsSharedByAlbedoGroups) {
  Scene scene = cloud_scene(3, 1.0);
  scene.film = {16, 12};
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

}  // namespace
}  // namespace brume
