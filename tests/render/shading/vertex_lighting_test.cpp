// Radiance transfer in rendered frames.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/io/merl_file.h"
#include "render/render_plan.h"
#include "render/renderer.h"
#include "render/transfer/transfer_store.h"
#include "tests/core/io/merl_writer.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/errors/transfer_errors.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

using std::numbers::pi;
constexpr auto none = Surface::Transfer::none;
constexpr auto shadow = Surface::Transfer::shadow;
constexpr auto interreflection = Surface::Transfer::interreflection;

Frame with(Scene scene, Surface::Transfer transfer) {
  for (Surface& surface : scene.surfaces) surface.transfer = transfer;
  return render_frame(scene, paper_settings);
}

TEST(VertexLighting, AWhiteBallMatchesItsEnvironment) {
  Scene scene;
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh = ball_mesh(24);
  surface.material.reflectance = glm::dvec3(1.0);
  surface.rotate = glm::normalize(glm::dquat(0.8, 0.1, -0.3, 0.4));
  scene.environment = even_sky(1.0f);
  scene.camera = {{0, 0.5, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.film = {32, 24};
  for (const auto transfer : {shadow, interreflection}) {
    const Frame frame = with(scene, transfer);
    // Roundings of float.
    for (const float x : frame.beauty) EXPECT_TRUE(x == 0.0f || std::abs(x - 1.0f) < 5e-6f) << x;
    EXPECT_GT(std::ranges::count_if(frame.depth, [](float z) { return std::isfinite(z); }), 200);
  }
}

// The integrating sphere: every place receives 1 - f from outside and the share f of what all
// others send. Three reflections leave out (rho f)^4.
TEST(VertexLighting, ABowlInAFurnaceIsAGeometricSeries) {
  for (const double to : {0.5 * pi, 2.4}) {
    const double f = 0.5 * (1.0 - std::cos(to));
    Scene scene = bowl_scene(to, interreflection);
    scene.surfaces[0].material.reflectance = {0.9, 0.6, 0.2};
    scene.environment = even_sky(1.0f);
    const auto expect = [&](const auto& wanted) {
      const Frame frame = render_frame(scene, paper_settings);
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        if (!(frame.depth[i] > 5.0f && std::isfinite(frame.depth[i]))) continue;
        for (std::size_t c = 0; c < 3; ++c) {
          const double rho = scene.surfaces[0].material.reflectance[static_cast<int>(c)];
          // The bound is that of a vertex, see
          // RadianceTransfer.OfAnIntegratingSphereIsAGeometricSeries, with 256 rays.
          EXPECT_NEAR(frame.beauty[4 * i + c], wanted(rho), 0.03 * rho) << f << ' ' << rho;
        }
      }
    };
    expect([f](double rho) {
      return rho * (1.0 - f) / (1.0 - rho * f) * (1.0 - std::pow(rho * f, 4));
    });
    scene.surfaces[0].transfer = shadow;
    expect([f](double rho) { return rho * (1.0 - f); });
    scene.surfaces[0].transfer = none;
    expect([](double rho) { return rho; });
  }
}

// The bounds are what was measured and a quarter more, less for what is without; the noise of these
// few samples is in it.
TEST(VertexLighting, MatchesTheReference) {
  struct Bounds {
    double error, without;  // at most, at least
  };
  constexpr Bounds bounds[] = {{0.009, 0.13}, {0.014, 0.15}, {0.015, 0.13}, {0.016, 0.14},
                               {0.45, 0.0},   {0.25, 0.0},   {0.06, 0.0}};
  const std::vector<ComparedError> rows = measure_transfer(250);
  ASSERT_EQ(rows.size(), std::size(bounds));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_LT(rows[i].error.rel_rmse, bounds[i].error) << rows[i].label;
    if (rows[i].other) {
      EXPECT_GT(rows[i].other->rel_rmse, bounds[i].without) << rows[i].label;
    }
  }
}

TEST(VertexLighting, RotatesWithSceneAndEnvironment) {
  Scene scene = ball_over_floor(interreflection);
  scene.environment.emplace().map = smooth_sky();
  const Frame before = render_frame(scene, paper_settings);
  const double degrees = 50.0;
  scene.environment->rotation += degrees;
  const Frame sky_alone = render_frame(scene, paper_settings);
  const glm::dquat turn = glm::angleAxis(glm::radians(degrees), glm::dvec3(0, 1, 0));
  scene.surfaces[0].rotate = turn;
  scene.camera.eye = turn * scene.camera.eye;
  scene.camera.target = turn * scene.camera.target;
  scene.camera.up = turn * scene.camera.up;
  const Frame after = render_frame(scene, paper_settings);
  EXPECT_LT(rel_rmse(after.beauty, before.beauty), 1e-5);
  EXPECT_GT(rel_rmse(sky_alone.beauty, before.beauty), 1e-2);
}

TEST(VertexLighting, UpdatesWhenItsInputsChange) {
  Scene scene = cloud_scene(10, 1.0);
  scene.film = {12, 12};
  scene.environment.emplace().map = smooth_sky();
  Surface surface;
  MeshArrays bowl;
  add_ball(bowl, 16, {0, 0, 0}, 1.0, 2.0, true);
  surface.mesh = to_mesh(bowl);
  surface.scale = 0.7;
  surface.transfer = shadow;
  scene.surfaces = {surface};
  Renderer renderer;
  Settings settings = paper_settings;
  settings.source_grid = {1000, 24};  // everything is made anew each time
  std::vector<float> last;
  const auto expect_as_new = [&](const char* what) {
    const Frame kept = render_frame(renderer, scene, settings);
    expect_finite(kept);
    EXPECT_EQ(kept.beauty, render_frame(scene, settings).beauty) << what;
    EXPECT_NE(kept.beauty, last) << what;
    last = kept.beauty;
  };
  expect_as_new("first");
  scene.environment->rotation = 70.0;
  expect_as_new("rotation");
  scene.lights[0].intensity.x += 1.0;
  expect_as_new("intensity");
  scene.lights[0].position.x += 1.0;
  expect_as_new("light");
  scene.surfaces[0].transfer = interreflection;
  expect_as_new("transfer");
  scene.surfaces[0].material.reflectance.x = 0.9;
  expect_as_new("reflectance");
  scene.surfaces[0].material.type = Material::Type::phong;
  scene.surfaces[0].material.specular = glm::dvec3(0.3);
  expect_as_new("material");
  scene.surfaces[0].translate.x = 0.3;
  expect_as_new("place");
  scene.medium.append({{0.5, 0.4, 0.6}, 0.4, 1.0});
  expect_as_new("medium");
  scene.medium.set_homogeneous_density(0.1);
  expect_as_new("fog");
  scene.optics.albedo = {0.5, 1.0, 0.9};
  expect_as_new("albedo");
  settings.paper_spread = true;
  expect_as_new("spread");
  settings.airlight = AirlightMethod::sliced;
  expect_as_new("method");
  settings.optical_depth_table = {16, 8};
  expect_as_new("table");
  scene.surfaces.push_back(scene.surfaces[0]);
  scene.surfaces[1].translate.x = -0.6;
  expect_as_new("surface");
  scene.surfaces[0].mesh = ball_mesh(8);
  expect_as_new("mesh");
  scene.environment.reset();
  expect_as_new("no sky");
  scene.surfaces[0].transfer = scene.surfaces[1].transfer = none;
  expect_as_new("no transfer");
}

TEST(VertexLighting, MeasuredMaterialMatchesItsSource) {
  Scene scene = ball_over_floor(interreflection);
  scene.medium.set_homogeneous_density(0.05);
  scene.lights.push_back({{-1, -1, 3}, {9, 9, 9}, {}});
  scene.environment.emplace().map = smooth_sky();
  Material& material = scene.surfaces[0].material;
  material.type = Material::Type::phong;
  material.reflectance = {0.5, 0.4, 0.3};
  material.specular = {0.2, 0.3, 0.4};
  material.exponent = 12.0;
  const TemporaryFolder folder;
  const auto file = folder.write("phong.binary", merl_of(material));
  for (const auto transfer : {none, shadow, interreflection}) {
    const Frame phong = with(scene, transfer);
    Scene measured = scene;
    measured.surfaces[0].material.measured = read_merl(file);
    measured.surfaces[0].material.type = Material::Type::measured;
    const Frame frame = with(measured, transfer);
    const double error = rel_rmse(frame.beauty, phong.beauty);
    // Twice what was measured: it is interpolated between its cells.
    EXPECT_LT(error, 2e-4);
  }
}

TEST(VertexLighting, UsesOnlyAvailableTransfer) {
  Scene scene = bowl_scene(2.0, shadow);
  scene.environment.emplace().map = smooth_sky();
  const auto transfers = std::make_shared<TransferStore>();
  Renderer renderer(transfers);
  const auto render = [&] { return render_frame(renderer, scene, paper_settings); };
  const auto why_skipped = [](const Frame& frame) {
    for (const SkippedStage& s : frame.statistics.skipped) {
      if (s.stage == Stage::transfer) return s.why;
    }
    return std::string();
  };
  const Frame without = render();
  EXPECT_EQ(why_skipped(without), "it is not computed yet");
  EXPECT_EQ(without.beauty, with(scene, none).beauty);

  const std::vector<TransferRequest> needed = needed_transfers(scene);
  ASSERT_EQ(needed.size(), 1u);
  EXPECT_FALSE(transfers->has(needed));
  std::stop_source stop;
  EXPECT_FALSE(
      transfers->make(needed, {}, {stop.get_token(), [&](double) { stop.request_stop(); }}));
  EXPECT_FALSE(transfers->has(needed));
  EXPECT_TRUE(transfers->make(needed, {}));
  EXPECT_TRUE(transfers->has(needed));
  const Frame shadowed = render();
  EXPECT_EQ(why_skipped(shadowed), "");
  EXPECT_EQ(shadowed.beauty, render_frame(scene, paper_settings).beauty);
  EXPECT_NE(shadowed.beauty, without.beauty);

  EXPECT_TRUE(transfers->make({}, {}));
  EXPECT_FALSE(transfers->has(needed)) << "nobody asks for it";
  EXPECT_EQ(render().beauty, without.beauty);
}

TEST(VertexLighting, IsComputedOnlyWithLight) {
  const auto why = [](const Scene& scene) {
    for (const SkippedStage& s : RenderPlan(scene, scene.film, {}).skipped) {
      if (s.stage == Stage::transfer) return s.why;
    }
    return std::string();
  };
  Scene scene = bowl_scene(2.0, none);
  EXPECT_EQ(why(scene), "no surface requests it");
  scene.surfaces[0].transfer = shadow;
  EXPECT_EQ(why(scene), "nothing emits light");
  scene.lights.push_back({{0, 0, 5}, {1, 1, 1}, {}});
  EXPECT_EQ(why(scene), "all light is direct");
  scene.surfaces[0].transfer = interreflection;
  EXPECT_EQ(why(scene), "");
  scene.surfaces[0].transfer = shadow;
  scene.medium.set_homogeneous_density(0.1);
  EXPECT_EQ(why(scene), "");
  scene.medium.set_homogeneous_density(0.0);
  scene.environment = even_sky(1.0f);
  EXPECT_EQ(why(scene), "");
  scene.surfaces.push_back(scene.surfaces[0]);
  EXPECT_EQ(needed_transfers(scene).size(), 1u) << "made once";
  const Frame frame = render_frame(scene, paper_settings);
  EXPECT_EQ(frame.statistics.stages.at(0).stage, Stage::transfer);
}

// At any point of its work, without harm to what comes next.
TEST(VertexLighting, CanBeStopped) {
  Scene scene = ball_over_floor(interreflection);
  scene.film = {64, 48};
  scene.environment.emplace().map = smooth_sky();
  scene.medium.set_homogeneous_density(0.05);
  const Frame uninterrupted = render_frame(scene, paper_settings);
  for (const double stop_fraction : {0.0, 0.2, 0.45, 0.6, 0.95}) {
    Renderer renderer;
    std::stop_source stop;
    std::atomic<double> last = 0.0;
    const auto progress = [&](double fraction) {
      EXPECT_TRUE(0.0 <= fraction && fraction <= 1.0);
      last = fraction;
      if (fraction >= stop_fraction) stop.request_stop();
    };
    EXPECT_FALSE(renderer.render(scene, scene.camera, scene.film, paper_settings, stop.get_token(),
                                 progress));
    EXPECT_GE(last, stop_fraction);
    EXPECT_LT(last, stop_fraction + 0.3);
    EXPECT_EQ(renderer.render(scene, scene.camera, scene.film, paper_settings)->beauty,
              uninterrupted.beauty);
  }
}

// Colors of vertices in frames: where they are the same everywhere, those of a base color.

constexpr glm::vec4 rust(0.75f, 0.5f, 0.25f, 0.5f);

// A ball over a floor in fog, which both send light into.
Scene foggy_room(AlphaMode alpha) {
  Scene scene = in_fog(Scene(), 0.3);
  scene.film = {8, 6};
  scene.camera = {{0, 1, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.lights = {{.position = {1, 2, 1}, .intensity = {20, 20, 20}}};
  scene.surfaces = {placed(Primitive::Shape::plane, glm::dvec3(6.0), {0, -0.8, 0}),
                    placed(Primitive::Shape::sphere, glm::dvec3(1.0), {0, 0, 0})};
  for (Surface& surface : scene.surfaces) {
    surface.material = metallic_roughness(glm::dvec3(1.0), 0.0, 0.8);
    surface.material.metallic_roughness.alpha = alpha;
  }
  return scene;
}

Scene with_vertices(Scene scene, auto&& color_at) {
  for (Surface& surface : scene.surfaces) {
    MeshArrays arrays = to_arrays(*surface.mesh);
    for (const glm::vec3& point : arrays.points) arrays.colors.push_back(color_at(point));
    surface.primitive.reset();
    surface.mesh = to_mesh(std::move(arrays));
  }
  return scene;
}

void expect_base_color(AlphaMode alpha, const std::vector<Settings>& all_settings) {
  const Scene plain = foggy_room(alpha);
  const Scene painted = with_vertices(plain, [](const glm::vec3&) { return rust; });
  Scene same = plain;
  for (Surface& surface : same.surfaces) {
    surface.material.metallic_roughness.base_color = glm::vec3(rust);
    if (alpha == AlphaMode::blend) surface.material.metallic_roughness.opacity = 0.5;
  }
  for (const Settings& settings : all_settings) {
    const Frame wanted = render_frame(same, settings);
    // Numbers are rounded in another order; light of all orders is iterated from there.
    EXPECT_LT(difference(render_frame(painted, settings).beauty, wanted.beauty).relative_rmse,
              1e-4);
  }
  // It matters.
  EXPECT_GT(difference(render_frame(plain, all_settings.front()).beauty,
                       render_frame(same, all_settings.front()).beauty)
                .relative_rmse,
            0.05);
}

TEST(VertexColors, AreThoseOfABaseColor) {
  expect_base_color(AlphaMode::opaque,
                    {sliced(4), all_orders(4, {.nodes = 20'000}), path_traced(1)});
}

TEST(VertexColors, HaveAnOpacity) {
  expect_base_color(AlphaMode::blend, {sliced(4), path_traced(1)});
}

TEST(VertexColors, AreInterpolatedWithoutTextures) {
  Scene scene = foggy_room(AlphaMode::opaque);
  scene.medium = Medium();
  scene.surfaces.resize(1);
  scene.film = {9, 9};
  scene.camera = {{0, 5, 0}, {0, -0.8, 0}, {0, 0, -1}, 40.0};
  scene.lights = {{.position = {0, 1e3, 0}, .intensity = glm::dvec3(1e6)}};
  const Scene red_to_blue = with_vertices(scene, [](const glm::vec3& point) {
    const float blue = 0.5f + point.x / 6.0f;
    return glm::vec4(1.0f - blue, 0.0f, blue, 1.0f);
  });
  for (const Settings& settings : {sliced(4), path_traced(1)}) {
    const Frame white = render_frame(scene, settings);
    const Frame frame = render_frame(red_to_blue, settings);
    const double half_width = 5.8 * std::tan(20.0 * std::numbers::pi / 180.0);
    for (std::size_t x = 0; x < 9; ++x) {
      const std::size_t pixel = 4 * (4 * 9 + x);
      const double middle = (static_cast<double>(x) - 4.0) / 4.5 * half_width;
      // Fresnel's part, 0.04, has no color.
      const auto share = [&](std::size_t c) {
        return static_cast<double>(frame.beauty[pixel + c]) /
               static_cast<double>(white.beauty[pixel + c]);
      };
      EXPECT_NEAR(share(2), 0.5 + middle / 6.0, 0.03) << x;
      EXPECT_NEAR(share(0), 0.5 - middle / 6.0, 0.03) << x;
      EXPECT_LT(share(1), 0.05) << x;
    }
  }
}

}  // namespace

}  // namespace brume
