// Light scattered more than once, against radiances by an independent path tracer
// (tests/golden/multiple_scattering.json), and against what must hold exactly.

#include "render/scattering/multiple_scattering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brume/mesh_arrays.h"
#include "core/io/scene/scene_file.h"
#include "render/output/compare.h"
#include "render/renderer.h"
#include "tests/render/golden_rays.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

Settings multiple_settings() {
  Settings settings = sliced_settings({}, Settings{}.slices);
  settings.scattering = Scattering::multiple;
  return settings;
}

// Enough for what holds on any grid.
Settings coarse_settings() {
  Settings settings = multiple_settings();
  settings.source_grid = {.nodes = 2000, .directions = 32};
  return settings;
}

// A quarter of the usual nodes: what is held to paths is as near to them by these.
Settings quarter_settings() {
  Settings settings = multiple_settings();
  settings.source_grid.nodes /= 4;
  return settings;
}

double airlight(const Scene& scene, const Settings& settings = multiple_settings()) {
  return static_cast<double>(render_frame(scene, settings).airlight[0]);
}

TEST(MultipleScattering, MatchesGoldenRays) {
  const std::vector<GoldenRay> rays = golden_rays();
  ASSERT_EQ(rays.size(), 20u);
  for (const GoldenRay& ray : rays) {
    double bound = 0.02;
    // A light inside the medium makes a field like 1 / r, which nodes do not resolve.
    if (ray.name.starts_with("lamp_inside")) bound = 0.05;
    if (ray.name.starts_with("furnace")) bound = 0.003;
    EXPECT_NEAR(airlight(ray.scattering_scene()), ray.radiance,
                bound * ray.radiance + 2.0 * ray.standard_error)
        << ray.name;
  }
}

// One ray through a ball of depth 10, lit from above.
Scene ball(double albedo, double anisotropy = 0.0) {
  Scene scene;
  scene.film = {1, 1};
  scene.camera = {{0, 0.3, 6}, {0.2, 0.1, 0}, {0, 1, 0}, 30.0};
  scene.medium.append({{0, 0, 0}, 1.0, albedo * 10.0 / std::sqrt(std::numbers::pi)});
  scene.lights.push_back({{2.6, 2.0, 1.6}, glm::dvec3(20.0), {}});
  scene.optics.albedo = glm::dvec3(albedo);
  scene.optics.anisotropy = anisotropy;
  return scene;
}

// Light from all directions that is only scattered stays as it is: a furnace.
double furnace_error(double depth, double anisotropy) {
  Scene scene = cloud_scene(5, depth);
  scene.film = {8, 8};
  scene.lights.clear();
  scene.environment = even_sky(1.0f);
  scene.optics.anisotropy = anisotropy;
  Settings settings = multiple_settings();
  settings.source_grid = {.nodes = 8000, .directions = 64};
  const Frame frame = render_frame(scene, settings);
  double squares = 0.0;
  for (std::size_t i = 0; i < 64; ++i) {
    const float radiance = frame.airlight[3 * i] + frame.transmittance[3 * i];
    squares += std::pow(static_cast<double>(radiance) - 1.0, 2.0);
  }
  return std::sqrt(squares / 64.0);
}

TEST(MultipleScattering, KeepsAUniformField) {
  EXPECT_LT(furnace_error(0.3, 0.0), 0.003);
  for (const double g : {-0.5, 0.0, 0.85}) EXPECT_LT(furnace_error(10.0, g), 0.003) << g;
  // What is dense shows that the sweeps have but 50 directions.
  EXPECT_LT(furnace_error(30.0, 0.0), 0.005);
}

// Black fog scatters each light once.
TEST(MultipleScattering, FadesWithTheAlbedo) {
  const auto gain = [](const Scene& scene) {
    Settings single = coarse_settings();
    single.scattering = Scattering::single;
    return airlight(scene, coarse_settings()) / airlight(scene, single);
  };
  EXPECT_NEAR(gain(ball(0.01)), 1.0, 0.015);
  EXPECT_GT(gain(ball(1.0)), 3.0);
}

TEST(MultipleScattering, DependsOnTheColoursOfLightsLinearly) {
  Scene both = ball(0.9);
  both.lights.push_back({{-3, 0.5, 1}, {0, 8, 16}, {}});
  Scene first = both;
  first.lights.pop_back();
  Scene second = both;
  second.lights.erase(second.lights.begin());
  const Frame all = render_frame(both, coarse_settings());
  const Frame one = render_frame(first, coarse_settings());
  const Frame other = render_frame(second, coarse_settings());
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(all.airlight[c], one.airlight[c] + other.airlight[c], 2e-3f * all.airlight[c]);
  }
}

TEST(MultipleScattering, EndsTheSameFromAnyFirstGuess) {
  Settings settings = coarse_settings();
  settings.scattering_limits.tolerance = 1e-5;
  Renderer renderer;
  Scene scene = ball(1.0, 0.4);
  renderer.render(scene, scene.camera, scene.film, settings);
  scene.lights[0].position = {-2.0, 1.0, 2.0};
  const Frame moved =
      *renderer.render(scene, scene.camera, scene.film, settings, {}, {}, {.warm_start = true});
  const Frame anew = render_frame(scene, settings);
  EXPECT_LT(moved.statistics.scattering->sweeps, anew.statistics.scattering->sweeps + 2);
  EXPECT_NEAR(moved.airlight[0], anew.airlight[0], 1e-4f * anew.airlight[0]);
}

TEST(MultipleScattering, DoesNotDependOnFramesBefore) {
  Scene scene = ball(1.0, 0.4);
  const auto render = [&scene](Renderer& renderer, const Settings& settings) {
    return renderer.render(scene, scene.camera, scene.film, settings)->airlight;
  };
  Renderer renderer;
  const std::vector<float> first = render(renderer, coarse_settings());
  scene.lights[0].position.x = -2.0;
  render(renderer, coarse_settings());
  scene.lights[0].position.x = 2.6;
  EXPECT_EQ(render(renderer, coarse_settings()), first);
  // Settings with the same grid, but another table of the light.
  Settings other_table = coarse_settings();
  other_table.optical_depth_table = {16, 8};
  Renderer other;
  render(other, other_table);
  EXPECT_EQ(render(other, coarse_settings()), first);
}

TEST(MultipleScattering, IsIndependentOfTheNumberOfThreads) {
  const Scene scene = ball(0.95, 0.5);
  Settings settings = coarse_settings();
  settings.threads = 1;
  const double one = airlight(scene, settings);
  settings.threads = 2;
  EXPECT_EQ(airlight(scene, settings), one);
}

// Homogeneous fog is scattered in as well, and beyond the finer grid.
TEST(MultipleScattering, IncludesFog) {
  Scene scene = ball(0.9);
  scene.medium.set_homogeneous_density(1e-7);
  // With fog there is a second level, which holds what is beyond 2.5 radii: 0.6% of the light.
  const double foggy = airlight(scene, quarter_settings());
  EXPECT_NEAR(foggy, airlight(ball(0.9), quarter_settings()), 1e-2 * foggy) << "hardly any";
}

// The mean airlight within a share of that of so many paths per pixel.
void expect_mean_of_paths(const Scene& scene, int paths_per_pixel, double share) {
  const double expected = mean_airlight(traced_truth(scene, paths_per_pixel));
  EXPECT_NEAR(mean_airlight(scene, quarter_settings()), expected, share * expected);
}

// Around a light behind a cloud, with a wall far away and without. With a lobe as narrow as that of
// light that was scattered once the error is 22%.
TEST(MultipleScattering, LobesWidenAroundLightsBehindClouds) {
  Scene scene = load_scene(sample_scene_file("dense_cloud"));
  scene.film = {16, 12};
  scene.optics.anisotropy = 0.85;
  scene.lights = {{{0.5, 0.8, -7.0}, glm::dvec3(600.0), {}}};
  for (const bool has_wall : {false, true}) {
    if (has_wall) scene.surfaces.push_back(wall(-20.0, 1.0));
    const Frame expected = traced_truth(scene, 1024);
    const Frame actual = render_frame(scene, quarter_settings());
    const ChannelPair pair{actual.airlight, expected.airlight};
    // 3.5% are the noise of the paths.
    EXPECT_LT(compare(std::span(&pair, 1)).rel_rmse, 0.06) << has_wall;
  }
}

// A cloud in a hollow ball under a sky.
TEST(MultipleScattering, ClosedWallsKeepTheSkyOut) {
  Scene scene = cloud_scene(5, 1.0);
  scene.camera.eye = {0, 0, 2};
  scene.film = {8, 8};
  scene.lights.clear();
  scene.environment = even_sky(1.0f);
  const double outdoors = mean_airlight(scene, coarse_settings());
  Surface& ball = scene.surfaces.emplace_back();
  ball.mesh = ball_mesh(24);
  ball.scale = 2.5;
  const double indoors = mean_airlight(scene, quarter_settings());
  EXPECT_GT(outdoors, 0.3);
  // A wall without thickness lets a little pass, where slanting light moves between nodes.
  EXPECT_LT(indoors, 0.01 * outdoors);
}

// Fog without Gaussians has a grid of its own: around lights, and within walls.
TEST(MultipleScattering, FogAloneMatchesPaths) {
  Scene scene;
  scene.medium.set_homogeneous_density(0.15);
  scene.optics.albedo = glm::dvec3(0.95);
  scene.camera.eye = {0, 0, 8};
  scene.film = {12, 9};
  scene.lights = {{{1.0, 1.0, 0.0}, glm::dvec3(3.0), {}}};
  Settings once = multiple_settings();
  once.scattering = Scattering::single;
  const double all = mean_airlight(scene, quarter_settings());
  EXPECT_LT(mean_airlight(scene, once), 0.5 * all);
  // Beyond the grid is no fog: 3% of the light is lost there.
  EXPECT_NEAR(all, mean_airlight(traced_truth(scene, 512)), 0.05 * all);
}

// A thin cloud in thin endless fog, seen against it: what rays meet far from the cloud counts. With
// the light at the border of a grid of two levels in place of it a third would be too much.
TEST(MultipleScattering, ThinFogGoesOnBeyondTheScene) {
  Scene scene = cloud_scene(5, 0.1);
  scene.medium.set_homogeneous_density(0.01);
  scene.camera.eye = {0, 0, 6};
  scene.film = {12, 9};
  scene.lights = {{{2.0, 2.0, 0.0}, glm::dvec3(10.0), {}}};
  expect_mean_of_paths(scene, 512, 0.02);
}

// Fog under a sky is a ball, brighter towards its border.
TEST(MultipleScattering, FogUnderASkyMatchesPaths) {
  Scene scene = cloud_scene(5, 0.1);
  scene.medium.set_homogeneous_density(0.1);
  scene.film = {12, 9};
  scene.lights.clear();
  scene.environment.emplace().map = gradient_sky();
  expect_mean_of_paths(scene, 256, 0.04);
}

// With nothing in it the ball is a mean free path around the origin.
TEST(MultipleScattering, FogAloneUnderASkyMatchesPaths) {
  Scene scene;
  scene.medium.set_homogeneous_density(0.1);
  scene.optics.albedo = glm::dvec3(0.95);
  scene.camera.eye = {0, 0, 8};
  scene.film = {12, 9};
  for (const bool has_sky : {true, false}) {
    if (has_sky) {
      scene.environment.emplace().map = gradient_sky();
    } else {
      scene.environment.reset();
      Light& sun = scene.lights.emplace_back();
      sun.kind = light::Directional{{1.0, -1.0, -0.5}};
      sun.intensity = glm::dvec3(1.0);
    }
    expect_mean_of_paths(scene, 512, 0.02);
  }
}

// What is reflected ten times over shows whether walls keep as much light as they should: a percent
// lost or gained at each reflection is ten in the end. Half a percent is what the grid gives.
TEST(MultipleScattering, WhiteWallsMatchPaths) {
  Scene scene = cloud_scene(5, 0.2);
  scene.camera.eye = {0, 0, 2};
  scene.film = {12, 12};
  scene.lights = {{{0.6, 0.9, -0.5}, glm::dvec3(1.0), {}}};
  Surface& ball = scene.surfaces.emplace_back();
  ball.mesh = ball_mesh(24);
  ball.scale = 2.5;
  for (const double reflectance : {0.0, 0.9}) {
    ball.material.reflectance = glm::dvec3(reflectance);
    SCOPED_TRACE(reflectance);
    expect_mean_of_paths(scene, 128, 0.05);
  }
}

// Slanting light ends at walls: where it goes on along them, this is four times too bright. The
// mean is 6% too dark, and the paths' noise another 5%.
TEST(MultipleScattering, TunnelsAreDark) {
  Scene scene = load_scene(sample_scene_file("tunnel"));
  scene.film = {16, 12};
  expect_mean_of_paths(scene, 64, 0.25);
}

// A wall on a floor with a light below, seen at a slight angle: the nodes next to the wall's foot
// are below the floor, and those above it see the light from points around them.
TEST(MultipleScattering, WallsTakeNoLightThroughTheFloor) {
  for (const float floor : {0.0f, 0.015f, 0.045f}) {
    Scene scene = cloud_scene(5, 0.2);
    scene.film = {2, 32};
    scene.camera = {
        {-4.0, 0.0, 0.2}, {0.3, 0.0, 0.02 + static_cast<double>(floor)}, {0, 0, 1}, 0.8};
    scene.lights = {{{0.2, 0.0, -0.05}, glm::dvec3(1.0), {}}};
    scene.surfaces.push_back(wall(static_cast<double>(floor), 3.0));
    const MeshArrays mesh{{{0.3f, -3, floor}, {0.3f, 3, floor}, {0.3f, 3, 3}, {0.3f, -3, 3}},
                          std::vector(4, glm::vec3(-1, 0, 0)),
                          {{0, 2, 1}, {0, 3, 2}}};
    scene.surfaces.emplace_back().mesh = to_mesh(mesh);
    const Frame frame = render_frame(scene, multiple_settings());
    float max = 0.0f;
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      max = std::max(max, frame.beauty[4 * i] - frame.airlight[3 * i]);
    }
    EXPECT_LT(max, 1e-3f) << floor;
  }
}

TEST(MultipleScattering, SurfacesSendLightBack) {
  const auto beside_wall = [](double reflectance) {
    Scene scene = cloud_scene(20, 1.0);
    scene.film = {8, 8};
    scene.lights = {{{0.0, 0.0, 3.0}, glm::dvec3(10.0), {}}};
    scene.surfaces.push_back(wall(-1.2, 6.0, reflectance));
    return mean_airlight(scene, coarse_settings());
  };
  const double black = beside_wall(0.0);
  const double white = beside_wall(1.0);
  EXPECT_GT(white, 1.1 * black);
  EXPECT_NEAR(beside_wall(0.5), 0.5 * (black + white), 0.05 * (white - black)) << "nearly linear";
}

}  // namespace
}  // namespace brume
