// Light that reaches surfaces through the medium, and environments, in rendered frames.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/infinity.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/environment.h"
#include "core/transport/average_depth.h"
#include "render/optical_depth/average_depth_grid.h"
#include "render/prepare/fog_extent.h"
#include "render/renderer.h"
#include "render/scattering/environment_light.h"
#include "render/simd/scatter_table.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/errors/surface_light_errors.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

using std::numbers::pi;

Surface ball(double radius) {
  Surface surface;
  surface.mesh = ball_mesh(64);
  surface.scale = radius;
  return surface;
}

void set_type(Material::Type type, Material& material) {
  material.type = type;
  material.specular = glm::dvec3(0.3);
  material.exponent = 5.0;
}

// The surface's radiance towards the eye, as the frame has it: without airlight, and without the
// medium between.
glm::dvec3 surface_part(const Frame& frame, std::size_t i) {
  glm::dvec3 radiance;
  for (std::size_t c = 0; c < 3; ++c) {
    radiance[static_cast<int>(c)] =
        static_cast<double>(frame.beauty[4 * i + c] - frame.airlight[3 * i + c]) /
        static_cast<double>(frame.transmittance[3 * i + c]);
  }
  return radiance;
}

TEST(ScatterTable, MeetsItsErrorBound) {
  const auto expect_close = [](const ScatterTable& table, const SpreadTable& spread) {
    for (double T = 1e-6; T < 40.0; T *= 1.0371) {
      const ZonalSh<double> exact = spread(T);
      const ScatterTable::Bands got = table(static_cast<float>(T));
      for (std::size_t l = 0; l < exact.size(); ++l) {
        const double factor = std::sqrt(4.0 * pi / (2.0 * static_cast<double>(l) + 1.0));
        EXPECT_NEAR(got[l], T * std::exp(-T) * factor * exact[l], 2e-5) << T << ' ' << l;
      }
    }
  };
  expect_close(ScatterTable::point(), SpreadTable::point());
  expect_close(ScatterTable::distant(), SpreadTable::distant());
  EXPECT_EQ(ScatterTable::point()(0.0f), ScatterTable::Bands{});
  EXPECT_EQ(ScatterTable::point()(std::numeric_limits<float>::infinity()), ScatterTable::Bands{});
}

void expect_average_depths_on_grids(const Scene& scene, double tolerance) {
  const GaussianTerms<double> gaussians(scene.medium);
  for (const Box& box : {Box{{-1, -1, -1}, {1, 1, 1}}, Box{{-9, 0.25, -9}, {9, 0.25, 9}},
                         Box{{2, 3, 4}, {2, 3, 4}}}) {
    const AverageDepthGrid grid(gaussians.all(), box);
    Random random(3);
    for (int n = 0; n < 500; ++n) {
      const glm::dvec3 p =
          0.5 * (box.low + box.high) + 0.5 * random.point(1.0) * (box.high - box.low);
      const double exact = average_depth(scene.medium, 0.0, p);
      EXPECT_NEAR(grid(p), exact, tolerance * exact);
    }
  }
}

TEST(AverageDepthGrid, MatchesTheSumWithinTwoPercent) {
  expect_average_depths_on_grids(cloud_scene(40, 3.0), 0.02);
}

// From near and from far. Each takes more time, so there are fewer nodes.
TEST(AverageDepthGrid, MatchesTheSumOfEllipsoids) {
  expect_average_depths_on_grids(ellipsoid_scene(40, 3.0, 5.0), 0.04);
}

// The bounds are what was measured and a third more; the noise of these few samples is in it.
TEST(SurfaceLight, MatchesTheReferenceForALightInFog) {
  struct Bounds {
    double error, paper;  // at most, at least
  };
  constexpr Bounds bounds[] = {{0.015, 0.33}, {0.015, 0.21},  {0.02, 0.08}, {0.025, 0.5},
                               {0.75, 0.1},   {0.045, 0.004}, {0.5, 0.55},  {0.055, 0.065},
                               {0.24, 1.2},   {0.036, 0.2},   {0.1, 1.8},   {0.02, 0.35},
                               {0.24, 1.2},   {0.037, 0.2}};
  const std::vector<ComparedError> rows = measure_surface_light(2'000);
  ASSERT_EQ(rows.size(), std::size(bounds));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_LT(rows[i].error.rel_rmse, bounds[i].error) << rows[i].label;
    EXPECT_GT(rows[i].other->rel_rmse, bounds[i].paper) << rows[i].label;
  }
}

// The average optical depth, eq. 27, hides that fog is thinner on one side; the grid knows. What is
// left is the light that the ball itself keeps from the fog.
TEST(SurfaceLight, MatchesTheReferenceForASkyInSmoke) {
  struct Row {
    Material::Type type;
    double depth;               // of the cloud
    double paper_error, error;  // measured, and a quarter more
  };
  const Row rows[] = {{Material::Type::diffuse, 0.5, 0.03, 0.03},
                      {Material::Type::diffuse, 2.0, 0.19, 0.03},
                      {Material::Type::phong, 0.5, 0.045, 0.03},
                      {Material::Type::phong, 2.0, 0.21, 0.03}};
  for (const Row& row : rows) {
    Scene scene = cloud_scene(30, row.depth);
    scene.lights.clear();
    scene.environment.emplace().map = smooth_sky();
    scene.surfaces = {ball(0.3)};
    set_type(row.type, scene.surfaces[0].material);
    scene.camera = {{0.3, 0.5, 0.9}, {0, 0, 0}, {0, 1, 0}, 30.0};
    scene.film = {5, 5};
    const SurfaceTruth reference(scene, {.samples = 40});
    ASSERT_GT(reference.size(), 10u);
    EXPECT_LT(reference.error(render_frame(scene, paper_settings)).rel_rmse, row.paper_error)
        << row.depth;
    EXPECT_LT(reference.error(render_frame(scene, sliced_settings({}, 24))).rel_rmse, row.error)
        << row.depth;
  }
}

// The model of fog is a ball around each point; the reference's is around the receiver.
TEST(SurfaceLight, MatchesTheReferenceForASkyInSmokeAndFog) {
  Scene scene = cloud_scene(30, 1.0);
  scene.lights.clear();
  scene.environment.emplace().map = smooth_sky();
  scene.surfaces = {ball(0.3)};
  scene.camera = {{0.3, 0.5, 0.9}, {0, 0, 0}, {0, 1, 0}, 30.0};
  scene.film = {5, 5};
  scene.medium.set_homogeneous_density(0.1);
  const SurfaceTruth reference(scene, {.samples = 40, .far = FogExtent(scene).surface_distance()});
  EXPECT_LT(reference.error(render_frame(scene, sliced_settings({}, 24))).rel_rmse, 0.04);
}

TEST(SurfaceLight, AWhiteBallMatchesItsEnvironment) {
  Scene scene;
  scene.surfaces = {ball(1.0)};
  scene.surfaces[0].material.reflectance = glm::dvec3(1.0);
  scene.camera = {{0, 0.5, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.film = {32, 24};
  scene.environment = even_sky(1.0f);
  const Frame frame = render_frame(scene, paper_settings);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const bool is_open = !std::isfinite(frame.depth[i]);
    EXPECT_EQ(frame.beauty[4 * i + 3], is_open ? 0.0f : 1.0f);
    for (std::size_t c = 0; c < 3; ++c) {
      // The background is exact, the ball to a few roundings of float.
      EXPECT_NEAR(frame.beauty[4 * i + c], 1.0f, is_open ? 0.0f : 2e-6f);
    }
  }
}

// A highlight among scattered light: how much brighter its peak is than the mean, and the share of
// the ball that is brighter than half the peak.
TEST(SurfaceLight, HighlightsSoftenAndWidenWithOpticalDepth) {
  Scene scene;
  scene.surfaces = {ball(0.2)};
  Material& material = scene.surfaces[0].material;
  material.type = Material::Type::phong;
  material.reflectance = glm::dvec3(0.0);
  material.specular = glm::dvec3(1.0);
  material.exponent = 60.0;
  scene.lights.push_back({{1.2, 1.2, 2.0}, {9, 9, 9}, {}});
  scene.camera = {{0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 14.0};
  scene.film = {64, 64};
  double last_contrast = infinity;
  double last_width = 0.0;
  for (const double b0 : {0.0, 0.1, 0.3, 0.8, 2.0}) {
    scene.medium.set_homogeneous_density(b0);
    const Frame frame = render_frame(scene, paper_settings);
    double peak = 0.0;
    double sum = 0.0;
    std::vector<double> values;
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (!std::isfinite(frame.depth[i])) continue;
      values.push_back(surface_part(frame, i).x);
      peak = std::max(peak, values.back());
      sum += values.back();
    }
    const double count = values.size();
    const double contrast = peak / (sum / count);
    // Where the halo reaches a tenth of the peak: the sharp core itself never widens.
    const double width =
        static_cast<double>(
            std::count_if(values.begin(), values.end(), [&](double v) { return v > 0.1 * peak; })) /
        count;
    EXPECT_LT(contrast, last_contrast) << b0;
    EXPECT_GE(width, last_width) << b0;
    last_contrast = contrast;
    last_width = width;
  }
}

// The light of eq. 28, by the paper's own method: far from single scattering where the medium is
// thick, T e^-T ends in black (surfaces.md).
TEST(Environment, PaperInscatteringMatchesThePublishedFormula) {
  Scene scene;
  scene.environment = even_sky(1.0f);
  scene.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 1.0};
  scene.film = {1, 1};
  scene.medium.append({{0, 0, 0}, 1.0, 1.0});
  Settings settings = paper_settings;
  settings.paper_spread = true;
  const Frame frame = render_frame(scene, settings);
  const double T = std::sqrt(pi);
  const double scattered = paper_point_spread_sh[0] * std::sqrt(4.0 * pi);
  EXPECT_NEAR(frame.airlight[0], T * std::exp(-T) * scattered, 1e-4);
  EXPECT_EQ(frame.beauty[0], frame.airlight[0] + frame.transmittance[0]);
  EXPECT_EQ(frame.beauty[3], 1.0f - frame.transmittance[0]);
}

// Alone it would be endless and black.
TEST(Environment, ShowsThroughHomogeneousFog) {
  Scene scene;
  scene.environment.emplace().map = smooth_sky();
  scene.surfaces = {ball(1.0)};
  scene.camera = {{0, 0.5, 4}, {0, 0, 0}, {0, 1, 0}, 60.0};
  scene.film = {16, 12};
  scene.medium.set_homogeneous_density(0.05);
  for (const auto method :
       {AirlightMethod::paper, AirlightMethod::sliced, AirlightMethod::reference}) {
    Settings settings;
    settings.airlight = method;
    const Frame frame = render_frame(scene, settings);
    expect_finite(frame);
    // D is the diagonal of the box around the ball.
    const double T = 0.05 * (2.0 * std::sqrt(3.0) + glm::length(scene.camera.eye));
    EXPECT_NEAR(frame.transmittance[0], std::exp(-T), 1e-4);
    EXPECT_TRUE(std::isinf(frame.depth[0]));
    const CameraRays rays(scene.camera, scene.film);
    const glm::dvec3 sky = environment_radiance(*scene.environment, rays.direction(0.5, 0.5));
    EXPECT_GT(frame.beauty[1], std::exp(-T) * sky.y) << "and its glow";
    EXPECT_LT(frame.beauty[1], sky.y);
  }
}

TEST(Environment, UpdatesWhenItsInputsChange) {
  Scene scene = cloud_scene(10, 1.0);
  scene.film = {12, 12};
  scene.environment.emplace().map = smooth_sky();
  scene.surfaces = {ball(0.4)};
  set_type(Material::Type::phong, scene.surfaces[0].material);
  Renderer renderer;
  Settings settings = paper_settings;
  const auto expect_as_new = [&](const char* what) {
    const Frame kept = render_frame(renderer, scene, settings);
    expect_finite(kept);
    EXPECT_EQ(kept.beauty, render_frame(scene, settings).beauty) << what;
  };
  expect_as_new("first");
  scene.environment->rotation = 70.0;
  expect_as_new("rotation");
  scene.environment->map = constant_sky(2.0f);
  expect_as_new("map");
  scene.surfaces[0].material.exponent = 2.0;
  expect_as_new("material");
  scene.surfaces[0].translate.x = 0.3;
  expect_as_new("place");
  scene.medium.append({{0.5, 0.4, 0.6}, 0.4, 1.0});
  expect_as_new("medium");
  scene.optics.albedo = {0.5, 1.0, 0.9};
  expect_as_new("albedo");
  settings.paper_spread = true;
  expect_as_new("spread");
  scene.surfaces.push_back(scene.surfaces[0]);
  scene.surfaces[1].material = Material();
  expect_as_new("surface");
  scene.environment->intensity = 0.0;
  expect_as_new("intensity");
  scene.environment.reset();
  expect_as_new("none");
}

TEST(Environment, CostsNothingWhenAbsent) {
  const auto skipped = [](const Scene& scene) {
    StageSet stages;
    for (const SkippedStage& s : render_frame(scene, paper_settings).statistics.skipped) {
      stages.add(s.stage);
    }
    return stages;
  };
  Scene scene;
  scene.film = {4, 4};
  scene.surfaces = {ball(1.0)};
  EXPECT_TRUE(skipped(scene).has(Stage::environment));
  EXPECT_TRUE(skipped(scene).has(Stage::surfaces));
  scene.environment = even_sky(1.0f);
  EXPECT_FALSE(skipped(scene).has(Stage::environment));
  EXPECT_FALSE(skipped(scene).has(Stage::surfaces));
  EXPECT_TRUE(skipped(scene).has(Stage::surface_scattering));
  scene.medium.set_homogeneous_density(0.1);
  EXPECT_FALSE(skipped(scene).has(Stage::surface_scattering));
}

}  // namespace
}  // namespace brume
