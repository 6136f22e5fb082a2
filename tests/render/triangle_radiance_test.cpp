// Frames that look up what triangles send against frames that shade every point.

#include "render/cpu/triangle_radiance.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/scene/mesh.h"
#include "render/render_plan.h"
#include "render/renderer.h"
#include "render/transfer/transfer_store.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/benchmark_meshes.h"

namespace brume {
namespace {

constexpr int enough = 2 * static_cast<int>(TriangleRadiance::rounds) + 2;  // frames

// Strips above the ground, so thin that their shadows fall between the probes of its triangles.
std::shared_ptr<const TriangleMesh> wires() {
  MeshBuilder mesh;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 from(-1.6 + 0.4 * i, 0.5, -1.0);
    mesh.grid(2, 2, false, [&](double u, double v) {
      return from + u * glm::dvec3(0.0, 0.0, 2.5) + v * glm::dvec3(0.006, 0.0, 0.0);
    });
  }
  return mesh.finish();
}

// A hilly ground, a ball above it, wires and a sheet that hangs beside it; in fog, under two lamps
// and a sky.
Scene hills() {
  Scene scene;
  MeshBuilder ground;
  ground.grid(50, 50, false, [](double u, double v) {
    const double x = 4.0 * u - 2.0;
    const double z = 4.0 * v - 2.0;
    return glm::dvec3(x, 0.1 * std::sin(3.0 * x) * std::cos(2.0 * z), z);
  });
  Surface hilly;
  hilly.mesh = ground.finish();
  Surface ball;
  ball.mesh = ball_mesh(24);
  ball.translate = {0.3, 0.7, 0.2};
  ball.scale = 0.4;
  MeshBuilder hanging;
  hanging.grid(20, 20, false, [](double u, double v) {
    return glm::dvec3(-1.2 + 0.8 * u, 0.9 + 0.3 * v, 0.8 * v - 0.5);
  });
  Surface sheet;
  sheet.mesh = hanging.finish();
  sheet.material.reflectance = {0.7, 0.3, 0.2};
  Surface wiry;
  wiry.mesh = wires();
  scene.surfaces = {hilly, ball, sheet, wiry};
  scene.medium.append({{0.2, 0.3, 0.5}, 0.8, 0.6});
  scene.medium.append({{-0.9, 0.4, -0.3}, 0.5, 0.8});
  scene.lights = {{{1.5, 3.0, 1.0}, {20, 18, 15}, {}}, {{-2.5, 2.0, 1.5}, {3, 5, 9}, {}}};
  scene.environment.emplace().map = constant_sky(0.3f);
  scene.camera = {{0.5, 1.2, 3.5}, {0.0, 0.3, 0.0}, {0, 1, 0}, 45.0};
  scene.film = {160, 120};
  return scene;
}

// Frames of one renderer, the camera standing still.
Frame last_of(Renderer& renderer, const Scene& scene, const Settings& settings, int frames) {
  Frame last;
  for (int i = 0; i < frames; ++i) {
    last = *renderer.render(scene, scene.camera, scene.film, settings);
  }
  return last;
}

Scene all_phong(Scene scene) {
  for (Surface& surface : scene.surfaces) surface.material.type = Material::Type::phong;
  return scene;
}

TEST(RadiancePatch, IsQuadratic) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const double size = random.power(-12.0, 12.0);
    std::array<glm::dvec3, 6> c;
    for (glm::dvec3& of : c) of = size * random.point(1.0);
    c[0] += glm::dvec3(4.0 * size);  // what is negative is cut off
    const auto exact = [&](double u, double v) {
      return c[0] + u * c[1] + v * c[2] + u * u * c[3] + u * v * c[4] + v * v * c[5];
    };
    std::array<glm::vec3, 6> values;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const glm::vec2& place = TriangleRadiance::probe_places[k];
      values[k] = glm::vec3(exact(static_cast<double>(place.x), static_cast<double>(place.y)));
    }
    const RadiancePatch patch(values);
    for (const glm::vec2& place : TriangleRadiance::probe_places) {
      const glm::dvec3 expected = exact(static_cast<double>(place.x), static_cast<double>(place.y));
      const glm::dvec3 got(patch.at(place.x, place.y));
      // Six coefficients, each rounded to 1/32767 of the greatest, which is 5.
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], 1e-3 * size) << i;
    }
  }
  EXPECT_EQ(RadiancePatch().at(0.3f, 0.3f), glm::vec3(0.0f));
}

// On every instruction set of the machine.
TEST(RadiancePatch, ManyAreThoseOfThePlainVersion) {
  Random random(2);
  std::vector<RadiancePatch> patches;
  std::vector<glm::vec2> uv;
  for (int i = 0; i < 37; ++i) {
    std::array<glm::vec3, 6> values;
    for (glm::vec3& v : values) v = glm::vec3(random.point(1.0)) + glm::vec3(0.5f);
    patches.emplace_back(values);
    uv.emplace_back(random.uniform(0.0, 0.5), random.uniform(0.0, 0.5));
  }
  std::vector<const RadiancePatch*> all;
  for (const RadiancePatch& patch : patches) all.push_back(&patch);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    std::vector<glm::vec3> radiance(all.size());
    evaluate_patches(all, uv, radiance);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const glm::vec3 plain = patches[k].at(uv[k].x, uv[k].y);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(radiance[k][c], plain[c], 1e-5f) << k;
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

// Expects the next frame of a renderer to be close to one that shades every point. Returns the
// share of pixels with a surface that differ at all.
double looked_up(Renderer& renderer, const Scene& scene, const Settings& settings) {
  const Frame kept = last_of(renderer, scene, settings, 1);
  const Frame shaded = render_frame(scene, settings);
  int differ = 0;
  int pixels = 0;
  for (std::size_t i = 0; i < kept.depth.size(); ++i) {
    if (!std::isfinite(kept.depth[i])) continue;
    const auto* a = &kept.beauty[4 * i];
    const auto* b = &shaded.beauty[4 * i];
    float off = 0.0f;
    for (int c = 0; c < 3; ++c) off = std::max(off, std::abs(a[c] - b[c]));
    ++pixels;
    differ += off > 0.0f ? 1 : 0;
    // The tolerance is of the brightest corner of a triangle, which is more than a pixel is.
    EXPECT_LT(off, 3.0f * TriangleRadiance::tolerance * std::max({b[0], b[1], b[2]})) << i;
  }
  return static_cast<double>(differ) / pixels;
}

TEST(TriangleRadiance, IsCloseToShading) {
  for (const bool is_lit_by_sky_only : {false, true}) {
    Scene scene = hills();
    if (is_lit_by_sky_only) scene.lights.clear();
    const Settings settings;
    Renderer renderer;
    last_of(renderer, scene, settings, enough);
    // Most of it is looked up, but not where shadows end.
    scene.camera.eye += glm::dvec3(0.05, 0.02, -0.03);
    EXPECT_GT(looked_up(renderer, scene, settings), 0.5);
    // The hanging sheet's other side, and what was hidden.
    scene.camera.eye = {-1.5, 3.0, -2.0};
    EXPECT_GT(looked_up(renderer, scene, settings), 0.1);
    last_of(renderer, scene, settings, enough);
    EXPECT_GT(looked_up(renderer, scene, settings), 0.5);
  }
}

TEST(TriangleRadiance, GoesWhenTransferComes) {
  Scene scene = hills();
  scene.surfaces[1].transfer = Surface::Transfer::shadow;
  const Settings settings;
  const auto transfers = std::make_shared<TransferStore>();
  Renderer renderer(transfers);
  last_of(renderer, scene, settings, enough);
  const std::vector<TransferRequest> requests = RenderPlan(scene, settings.airlight).transfers;
  ASSERT_TRUE(transfers->make(requests, {}));
  EXPECT_EQ(last_of(renderer, scene, settings, 1).beauty, render_frame(scene, settings).beauty);
}

TEST(TriangleRadiance, IsTheSameWithAnyThreads) {
  const Scene scene = hills();
  Settings one;
  one.threads = 1;
  Settings three;
  three.threads = 3;
  Renderer with_one;
  Renderer with_three;
  for (int i = 0; i < enough; ++i) {
    ASSERT_EQ(with_one.render(scene, scene.camera, scene.film, one)->beauty,
              with_three.render(scene, scene.camera, scene.film, three)->beauty)
        << i;
  }
}

// The renderer that has kept radiance of what was before shades the first frame of a changed scene
// as one that has seen nothing.
TEST(TriangleRadiance, GoesWithSurfacesAndLight) {
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> changes{
      {"intensity", [](Scene& s) { s.lights[0].intensity *= 1.5; }},
      {"lamp moved", [](Scene& s) { s.lights[1].position.x += 0.1; }},
      {"lamp off", [](Scene& s) { s.lights[1].on = false; }},
      {"Gaussian",
       [](Scene& s) {
         s.medium.append({{0.0, 0.2, 0.0}, 0.5, 0.3});
       }},
      {"fog", [](Scene& s) { s.medium.set_homogeneous_density(0.05); }},
      {"albedo", [](Scene& s) { s.optics.albedo = glm::dvec3(0.5); }},
      {"anisotropy", [](Scene& s) { s.optics.anisotropy = 0.4; }},
      {"sky", [](Scene& s) { s.environment->intensity = 0.5; }},
      {"no sky", [](Scene& s) { s.environment.reset(); }},
      {"reflectance", [](Scene& s) { s.surfaces[0].material.reflectance *= 0.9; }},
      {"material", [](Scene& s) { s.surfaces[1].material.type = Material::Type::phong; }},
      {"surface moved", [](Scene& s) { s.surfaces[1].translate.y += 0.1; }},
      {"surface gone", [](Scene& s) { s.surfaces.erase(s.surfaces.begin() + 1); }},
      {"transfer", [](Scene& s) { s.surfaces[1].transfer = Surface::Transfer::shadow; }},
  };
  const Scene scene = hills();
  const Settings settings;
  for (const auto& [name, change] : changes) {
    Renderer renderer;
    last_of(renderer, scene, settings, enough);
    Scene changed = scene;
    change(changed);
    EXPECT_EQ(last_of(renderer, changed, settings, 1).beauty,
              render_frame(changed, settings).beauty)
        << name;
  }
  Renderer renderer;
  last_of(renderer, scene, settings, enough);
  Settings finer;
  finer.light_table = {256, 128};
  EXPECT_EQ(last_of(renderer, scene, finer, 1).beauty, render_frame(scene, finer).beauty);
}

TEST(TriangleRadiance, IsOfDiffuseSurfacesInSinglePrecisionOnly) {
  const Settings settings;
  Settings plain;
  plain.arithmetic = Settings::Arithmetic::plain_double;
  Renderer of_phong;
  const Scene phong = all_phong(hills());
  EXPECT_EQ(last_of(of_phong, phong, settings, enough).beauty,
            render_frame(phong, settings).beauty);
  Renderer in_double;
  EXPECT_EQ(last_of(in_double, hills(), plain, 4).beauty, render_frame(hills(), plain).beauty);
}

}  // namespace
}  // namespace brume
