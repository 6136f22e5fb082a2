// Pixels of the device whose neighbours may differ: borders of tiles, the place of a
// light, and surfaces seen edge-on.

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/scene/camera_rays.h"
#include "render/gl/gl_plan.h"
#include "render/gl_renderer.h"
#include "tests/contains.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/plan_cases.h"
#include "tests/render/regions.h"
#include "tests/render/repeatable_frames.h"
#include "tests/render/seams.h"
#include "tests/render/test_scenes.h"
#include "tests/render/visibility/box_on_floor.h"
#include "tools/bench/measure/hard_cases.h"

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

// A region of a film has the bits of the whole picture on the device, too.

class GlRegions : public GlFrames {};

TEST_F(GlRegions, HaveTheBitsOfTheWholePicture) {
  Settings settings = quick_slices();
  settings.samples = 2;
  expect_region_matches(*gl_, 2, {{72, 40}, settings});
  settings.samples = 1;
  settings.airlight_scale = 2;
  expect_region_matches(*gl_, 3, {{200, 60}, settings});
  settings.airlight_scale = 4;
  settings.airlight = AirlightMethod::paper;
  expect_region_matches(*gl_, 5, {{340, 60}, settings});
}

// A frame of the device, too, is a function of scene, camera and settings.

TEST(GlRepeatableFrames, SlicedInterpolated) {
  Settings settings = quick_slices();
  settings.airlight_scale = 4;
  expect_repeatable(
      [] {
        std::string problem;
        std::unique_ptr<FrameRenderer> renderer = GlRenderer::create(nullptr, problem);
        EXPECT_TRUE(renderer) << problem;
        return renderer;
      },
      settings);
}

// The hard cases of resources/hard_cases on the device.

TEST(GlHardCases, MatchTheGoldenValues) {
  std::string problem;
  const std::unique_ptr<GlRenderer> gl = GlRenderer::create(nullptr, problem, true);
  ASSERT_TRUE(gl) << problem;
  for (const HardCase& hard_case : load_hard_cases()) {
    const HardCaseError error = sliced_error(*gl, hard_case);
    EXPECT_LE(error.airlight, hard_case.bound) << hard_case.name;
    EXPECT_LE(error.transmittance, hard_case_transmittance_bound) << hard_case.name;
  }
}

// The stages of the device are decided without one.

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
