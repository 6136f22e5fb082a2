#include "render/renderer.h"
#include "render/display/to_display.h"
#include "render/quality/error_estimate.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <thread>
#include <vector>

#include "brume/edits.h"
#include "brume/render.h"
#include "core/scene/materials/brdf.h"
#include "core/transport/point_spread.h"
#include "tests/core/math/sh_convolve.h"
#include "tests/render/regions.h"
#include "tests/render/repeatable_frames.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

Scene busy_scene() {
  Scene scene = in_fog(cloud_scene(80, 2.0), 0.02);
  scene.lights.push_back({{-3, 2, 3}, {3, 5, 8}, {}});
  scene.surfaces.push_back(wall(-1.0, 2.0));
  scene.film = {48, 40};
  return scene;
}

std::size_t center_pixel(const Frame& frame) {
  return static_cast<std::size_t>(frame.film.height / 2 * frame.film.width + frame.film.width / 2);
}

TEST(Renderer, DiffuseWallHasTheRadianceItShould) {
  Scene scene = seen_by({{0, 0, 3}, {0, 0, 0}, {0, 1, 0}, 10.0}, {21, 21});
  scene.lights.push_back({{1.5, 0, 2}, {50, 20, 10}, {}});
  scene.surfaces.push_back(wall(0.0, 1.0, 0.8));
  const double d2 = 1.5 * 1.5 + 2.0 * 2.0;
  const double cosine = 2.0 / std::sqrt(d2);
  const double bare = 0.8 / std::numbers::pi * 50.0 * cosine / d2;
  Frame frame = render_frame(scene, paper_settings);
  const std::size_t i = center_pixel(frame);
  EXPECT_NEAR(frame.beauty[4 * i], bare, 1e-5 * bare);
  EXPECT_NEAR(frame.beauty[4 * i + 1], 0.4 * bare, 1e-5 * bare);
  EXPECT_NEAR(frame.depth[i], 3.0, 1e-5);
  EXPECT_EQ(frame.beauty[4 * i + 3], 1.0f);

  // In fog the light is attenuated on both ways, some is scattered on the way to the wall (eq. 25),
  // and airlight is added (eq. 29).
  scene.medium.set_homogeneous_density(0.1);
  frame = render_frame(scene, paper_settings);
  const double both_ways = bare * std::exp(-0.1 * (3.0 + std::sqrt(d2)));
  EXPECT_NEAR(frame.transmittance[3 * i], std::exp(-0.3), 1e-6);
  EXPECT_GT(frame.airlight[3 * i], 0.0f);
  const double T = 0.1 * std::sqrt(d2);
  const glm::dvec3 delta = glm::normalize(glm::dvec3(1.5, 0, 2));
  const double scattered_share =
      T *
      sh_evaluate(sh_convolve(sh_convolve(sh_basis(6, delta), SpreadTable::point()(T)),
                              clamped_cosine_sh()),
                  glm::dvec3(0, 0, 1)) /
      cosine;
  EXPECT_NEAR(frame.beauty[4 * i] - frame.airlight[3 * i], both_ways * (1.0 + scattered_share),
              1e-4 * both_ways);
}

TEST(Renderer, SurfacesCastShadows) {
  Scene scene = seen_by({{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 30.0}, {31, 31});
  scene.lights.push_back({{0, 4, 4}, {50, 50, 50}, {}});
  scene.surfaces.push_back(wall(0.0, 3.0));
  const Frame open = render_frame(scene, paper_settings);
  scene.surfaces.push_back(wall(0.0, 0.5));
  scene.surfaces.back().translate = {0, 2, 2};  // between the light and the middle of the wall
  const Frame shadowed = render_frame(scene, paper_settings);
  const std::size_t i = center_pixel(open);
  EXPECT_GT(open.beauty[4 * i], 0.0f);
  EXPECT_EQ(shadowed.beauty[4 * i], 0.0f);
}

TEST(Renderer, SurfacesArePlacedByTheirTransform) {
  Scene scene = seen_by({{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 10.0}, {9, 9});
  scene.surfaces.push_back(ball_surface(64, 2.0, {0, 0, 1}));
  EXPECT_NEAR(
      render_frame(scene, paper_settings).depth[center_pixel(render_frame(scene, paper_settings))],
      7.0, 1e-2);
  // A wall turned by 90 degrees about y is seen edge on.
  scene.surfaces = {wall(0.0, 1.0)};
  scene.surfaces[0].translate = {0.3, 0, 0};
  scene.surfaces[0].rotate = glm::dquat(std::sqrt(0.5), 0, std::sqrt(0.5), 0);
  const Frame frame = render_frame(scene, paper_settings);
  EXPECT_TRUE(std::isinf(frame.depth[center_pixel(frame)]));
}

TEST(Renderer, ReusesOnlyUnchangedData) {
  Scene scene = busy_scene();
  Renderer renderer;
  const auto check = [&](const char* what) {
    const Frame kept = render_frame(renderer, scene, paper_settings);
    EXPECT_EQ(kept.beauty, render_frame(scene, paper_settings).beauty) << what;
  };
  check("first");
  scene.camera.eye = {0.5, 0.4, 3.5};
  check("camera moved");
  scene.lights[0].position.x += 0.7;
  check("light moved");
  scene.lights.erase(scene.lights.begin());
  check("light gone");
  Gaussian g = scene.medium.gaussian(3);
  g.radius *= 2.0;
  MediumEdit::change(scene.medium, std::vector{scene.medium.ids()[3]}, std::vector{g})
      .apply(scene.medium);
  check("Gaussian changed");
  scene.medium.set_homogeneous_density(0.0);
  check("b0 changed");
  scene.surfaces[0].translate.z -= 0.4;
  check("surface moved");
  scene.surfaces[0].material.reflectance = glm::dvec3(0.9, 0.1, 0.1);
  check("material changed");
  scene.film = {33, 17};
  check("film changed");
}

TEST(Renderer, StopsOnRequest) {
  Scene scene = on_film(cloud_scene(300, 3.0), {1024, 1024});
  Settings settings;
  settings.airlight = AirlightMethod::reference;  // minutes, if it went on
  std::stop_source source;
  double last = 0.0;
  std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    source.request_stop();
  });
  Renderer renderer;
  EXPECT_FALSE(renderer.render(scene, scene.camera, scene.film, settings, source.get_token(),
                               [&](double fraction) { last = fraction; }));
  EXPECT_LT(last, 1.0);
}

TEST(Renderer, LightsSwitchedOffAreAsIfNotThere) {
  Scene scene = on_film(busy_scene(), {16, 16});
  scene.lights = {{{2, 3, 2}, {10, 10, 10}, {}}, {{-2, 1, 3}, {1, 5, 9}, {}}};
  Scene one = scene;
  scene.lights[1].on = false;
  one.lights.pop_back();
  const Frame frame = render_frame(scene, paper_settings);
  EXPECT_EQ(frame.beauty, render_frame(one, paper_settings).beauty);
  bool found = false;
  for (const SkippedStage& s : frame.statistics.skipped) {
    found = found || (s.stage == Stage::lights && s.why == "switched off: 1");
  }
  EXPECT_TRUE(found);
  scene.lights[1].on = true;
  EXPECT_NE(frame.beauty, render_frame(scene, paper_settings).beauty);
}

TEST(Renderer, CountsPairs) {
  const Frame frame = render_frame(busy_scene(), paper_settings);
  EXPECT_EQ(frame.statistics.gaussians_total, 80u);
  EXPECT_EQ(frame.statistics.gaussians_used, 80u);
  EXPECT_GT(frame.statistics.light_pairs, 0u);
  EXPECT_GT(frame.statistics.view_pairs, 0u);
  EXPECT_LE(frame.statistics.view_pairs, 80u * 48u * 40u + 80u * 80u);

  Scene small = on_film(busy_scene(), {6, 5});
  Settings reference;
  reference.airlight = AirlightMethod::reference;
  const FrameStatistics counted = render_frame(small, reference).statistics;
  EXPECT_GT(counted.view_pairs, 0u);
  EXPECT_GT(counted.light_pairs, counted.view_pairs);  // at each point of a ray one to the light
}

TEST(Display, PreservesColoursBelowTheKnee) {
  Frame frame;
  frame.film = {3, 1};
  frame.beauty = {0, 0, 0, 0, 0.2f + 0.04f, 0.2f + 0.04f, 0.2f + 0.04f, 1, 1e30f, 1, 0, 1};
  const auto bytes = to_display(frame, {});
  EXPECT_EQ(bytes[0], 0);
  // sRGB of 0.2 (the curve takes away 0.04), dithered.
  EXPECT_NEAR(bytes[3], 123.55, 1.0);
  EXPECT_GE(bytes[6], 254);
}

// Work and error of a fixed set of frames, so that a change which makes them costlier or worse is
// seen without a clock. Pairs of Gaussians and rays are what frames cost; they are the same on
// every machine but for vectors of other lengths, hence a quarter of slack; so has the error, which
// some pixels tell.

struct MeasuredScene {
  const char* name;
  Scene scene;
  int slices, scale;
  // Measured pairs in millions, and the error.
  double view_pairs, light_pairs, error;
};

TEST(Regression, FramesTakeNoMoreWorkAndAreNoWorse) {
  const MeasuredScene rows[] = {
      {"two Gaussians", two_gaussians(), 24, 1, 0.0506, 0.0273, 0.0012},
      {"cloud of 30", cloud(30, 1.0), 24, 1, 0.213, 0.110, 0.0004},
      {"cloud of 300", cloud(300, 3.0), 24, 4, 0.538, 1.008, 0.0023},
      {"dense cloud of 30", cloud(30, 10.0), 48, 4, 0.175, 0.567, 0.0021},
      {"box of 3,000", box_scene(3000, 2), 24, 4, 0.882, 1.338, 0.013},
  };
  for (MeasuredScene row : rows) {
    row.scene.film = {200, 150};
    Settings settings;
    settings.airlight_scale = row.scale;
    settings = sliced_settings(settings, row.slices);
    const Frame frame = render_frame(row.scene, settings);
    const auto sample = ErrorSample::create(row.scene, row.scene.camera, frame, 60, 1, 1e-3);
    const double error = sample->measure(frame).rel_rmse;
    const double view = 1e-6 * static_cast<double>(frame.statistics.view_pairs);
    const double light = 1e-6 * static_cast<double>(frame.statistics.light_pairs);
    EXPECT_LT(view, 1.25 * row.view_pairs) << row.name;
    EXPECT_LT(light, 1.25 * row.light_pairs) << row.name;
    EXPECT_LT(error, 1.25 * row.error) << row.name;
  }
}

// A region of a film has the bits that its pixels have in the picture of the whole film. A failure
// names its seed; BRUME_REGION_SEED=n tries that scene alone.

Settings on_cpu(AirlightMethod method, Scattering scattering = Scattering::single) {
  Settings settings = sliced_settings({}, 8);
  settings.airlight = method;
  settings.scattering = scattering;
  settings.paths = 3;
  settings.optical_depth_table = {16, 8};
  settings.shadow_cells = 32;
  settings.source_grid = {200, 12};
  settings.scattering_limits = {.degree = 3, .light_degree = 5, .sweeps = 4};
  return settings;
}

void expect_regions_match(unsigned first, unsigned count, const RegionRequest& request) {
  Renderer renderer;
  for (unsigned seed = first; seed < first + random_cases(count); ++seed) {
    expect_region_matches(renderer, seed, request);
  }
}

TEST(Regions, HaveTheBitsOfTheWholePictureByEveryMethod) {
  for (const AirlightMethod method : {AirlightMethod::sliced, AirlightMethod::paper}) {
    expect_regions_match(1, 4, {{120, 72}, on_cpu(method)});
  }
  expect_regions_match(101, 2, {{120, 72}, on_cpu(AirlightMethod::sliced, Scattering::multiple)});
  expect_regions_match(201, 4, {{120, 72}, on_cpu(AirlightMethod::path)});
  expect_regions_match(301, 1, {{40, 20}, on_cpu(AirlightMethod::reference)});
}

TEST(Regions, HaveTheBitsOfTheWholePictureWhereAirlightIsInterpolated) {
  for (const AirlightMethod method : {AirlightMethod::sliced, AirlightMethod::paper}) {
    Settings settings = on_cpu(method);
    settings.airlight_scale = 2;
    expect_regions_match(401, 3, {{301, 163}, settings});
    settings.airlight_scale = 4;
    expect_regions_match(501, 3, {{500, 261}, settings});
  }
}

TEST(Regions, HaveTheBitsOfTheWholePictureWherePixelsAreSampled) {
  Settings settings = on_cpu(AirlightMethod::sliced);
  settings.samples = 4;
  expect_regions_match(601, 4, {{120, 72}, settings});
  settings.airlight_scale = 4;
  expect_regions_match(701, 3, {{530, 270}, settings});
  Settings paths = on_cpu(AirlightMethod::path);
  paths.samples = 2;
  paths.paths = 32;
  expect_regions_match(801, 2, {{24, 16}, paths});
}

// Settings are chosen for all regions alike, and layers are those of the whole picture.
TEST(Regions, OfRequestsHaveTheBitsOfTheWholePicture) {
  OutputLayers layers;
  layers.lights = layers.optical_depth = layers.planar_depth = layers.normal = layers.albedo = true;
  layers.position = layers.motion = layers.objects = true;
  for (const unsigned seed : {1u, 2u}) {
    Scene scene = on_film(cloud_scene(12, 2.0, seed), {420, 61});
    scene.surfaces.push_back(wall(-0.5, 1.0));
    RenderRequest request{.max_error = seed == 1 ? 0.05 : 0.02,
                          .scattering = Scattering::single,
                          .samples = 4,
                          .layers = layers,
                          .backend = Backend::cpu};
    SceneRenderer renderer;
    const Frame whole = *renderer.render(scene, request);
    request.film = film_region(scene.film, {0.05, 0.2}, {0.2, 0.7});
    const Frame part = *renderer.render(scene, request);
    EXPECT_EQ(part.statistics.airlight, whole.statistics.airlight);
    expect_same_pixels(whole, part);
  }
}

// A frame is a function of scene, camera and settings.

std::unique_ptr<FrameRenderer> create_cpu_renderer() {
  return std::make_unique<Renderer>();
}

TEST(RepeatableFrames, SlicedInterpolated) {
  Settings settings = sliced_settings({}, 12);
  settings.airlight_scale = 4;
  expect_repeatable(create_cpu_renderer, settings);
}

TEST(RepeatableFrames, SlicedEveryPixel) {
  expect_repeatable(create_cpu_renderer, sliced_settings({}, 16));
}

TEST(RepeatableFrames, Merged) {
  const std::vector<Scene> scenes = crowded_scenes();
  const Settings settings = sliced_settings({}, 8);
  ASSERT_GT(render_frame(scenes[0], settings).statistics.gaussians_merged, 0u);
  expect_repeatable(create_cpu_renderer, settings, scenes);
}

TEST(RepeatableFrames, Paper) {
  expect_repeatable(create_cpu_renderer, paper_settings);
}

TEST(RepeatableFrames, Paths) {
  Settings settings;
  settings.airlight = AirlightMethod::path;
  settings.paths = 2;
  expect_repeatable(create_cpu_renderer, settings);
}

// On a farm frames come from processors with other vector instructions: they differ by rounding.
TEST(RepeatableFrames, AcrossVectorInstructions) {
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  ASSERT_FALSE(targets.empty());
  Settings solved = all_orders(16, {.nodes = 2000, .directions = 32});
  for (Scene scene : {cloud_scene(30, 2.0), in_fog(cut_by_a_surface(), 0.05)}) {
    scene.film = {16, 12};
    for (const Settings& settings : {sliced(16), solved, paper_settings}) {
      std::vector<Frame> frames;
      for (const std::int64_t target : targets) {
        hwy::SetSupportedTargetsForTest(target);
        frames.push_back(render_frame(scene, settings));
      }
      hwy::SetSupportedTargetsForTest(0);
      for (std::size_t k = 1; k < frames.size(); ++k) {
        SCOPED_TRACE(airlight_name(settings) + ", " + hwy::TargetName(targets[k]));
        // The iteration for all orders is accelerated by what sweeps change, whose rounding grows.
        const double bound = settings.scattering == Scattering::multiple ? 1e-4 : 1e-5;
        EXPECT_LT(rel_rmse(frames[k].beauty, frames[0].beauty), bound);
        EXPECT_LT(rel_rmse(frames[k].airlight, frames[0].airlight), bound);
      }
    }
  }
}

}  // namespace

}  // namespace brume
