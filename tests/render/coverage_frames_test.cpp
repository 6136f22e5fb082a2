// Frames of surfaces with holes, and of panes.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "core/scene/materials/coverage.h"
#include "render/samples/mean_frame.h"
#include "render/visibility/ray_caster.h"
#include "tests/render/coverage_scenes.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

Scene with(Scene scene, std::vector<Surface> surfaces, double height = 1.0) {
  for (Surface& surface : surfaces) {
    surface.translate.y += height;
    scene.surfaces.push_back(surface);
  }
  return scene;
}

// The floor as seen from right above, without fog.
Scene floor_from_above() {
  Scene scene = on_film(lit_from_above(), {9, 9});
  scene.camera = {{0.3, 0.9, 0.2}, {0.3, 0.0, 0.2}, {0, 0, -1}, 20.0};
  return scene;
}

glm::vec3 mean_of(const Frame& frame) {
  glm::vec3 sum(0.0f);
  const std::size_t pixels = frame.depth.size();
  for (std::size_t i = 0; i < pixels; ++i) {
    sum += glm::vec3(frame.beauty[4 * i], frame.beauty[4 * i + 1], frame.beauty[4 * i + 2]);
  }
  return sum / static_cast<float>(pixels);
}

// The texture's edges are where squares of their own end.
TEST(CoverageFrames, HolesAreThoseOfSquaresOfTheirOwn) {
  const Scene leaf = in_fog(with(lit_from_above(), {checkered_leaf()}), 0.1);
  const Scene squares = in_fog(with(lit_from_above(), leaf_of_squares()), 0.1);
  const Scene solid = [&] {
    Scene scene = leaf;
    scene.surfaces.back().material.metallic_roughness.alpha = AlphaMode::opaque;
    return scene;
  }();
  for (const Settings& settings : {sliced(12), all_orders(12, {.nodes = 4000, .directions = 32})}) {
    const Frame wanted = render_frame(squares, settings);
    EXPECT_LT(rel_rmse(render_frame(leaf, settings).beauty, wanted.beauty), 5e-3);
  }
  EXPECT_GT(rel_rmse(render_frame(solid, sliced(12)).beauty, render_frame(leaf, sliced(12)).beauty),
            0.2);
  // Both of the same points and random numbers, so that few pixels tell.
  for (const auto& [settings, bound] :
       {std::pair(reference_settings(1e-4), 1e-3), {path_traced(16), 0.02}}) {
    const Frame wanted = render_frame(on_film(squares, {12, 9}), settings);
    const Frame frame = render_frame(on_film(leaf, {12, 9}), settings);
    EXPECT_LT(rel_rmse(frame.airlight, wanted.airlight), bound);
    EXPECT_LT(rel_rmse(frame.beauty, wanted.beauty), bound);
  }
}

TEST(CoverageFrames, FloorsBehindPanesAreLitThroughThem) {
  const Scene plain = floor_from_above();
  const glm::dvec3 crossing(0.9, 0.5, 0.1);
  for (const auto& [opacity, mode] : {std::pair{1.0, AlphaMode::opaque}, {0.5, AlphaMode::blend}}) {
    const Scene shaded = with(plain, {pane(mode, opacity, crossing)});
    for (const Settings& settings : {sliced(12), path_traced(64)}) {
      const glm::vec3 lit = mean_of(render_frame(plain, settings));
      const glm::vec3 behind = mean_of(render_frame(shaded, settings));
      for (int c = 0; c < 3; ++c) {
        const double share = 1.0 - opacity * (1.0 - crossing[c]);
        // Paths have what floor and pane reflect to each other, too.
        const bool is_path = settings.airlight == AirlightMethod::path;
        EXPECT_NEAR(behind[c] / lit[c], share, is_path ? 0.1 : 1e-5) << c;
      }
    }
  }
}

TEST(CoverageFrames, PanesShowWhatIsBehind) {
  // The pane is between eye and floor, and has no light of its own.
  Scene plain = floor_from_above();
  plain.lights[0].position = {0.3, 0.4, 0.2};
  const glm::dvec3 crossing(0.9, 0.5, 0.1);
  const Scene seen = with(plain, {pane(AlphaMode::opaque, 1.0, crossing)}, 0.6);
  const glm::vec3 floor = mean_of(render_frame(plain, sliced(12)));
  const glm::vec3 pane_and_floor = mean_of(render_frame(seen, sliced(12)));
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(pane_and_floor[c], crossing[c] * floor[c], 1e-5 * floor[c]);
  }
  // Half of the light crosses it, then less.
  EXPECT_NEAR(render_frame(seen, sliced(12)).depth[40], 0.9, 1e-4);
  Scene darker = seen;
  darker.surfaces[1].material.metallic_roughness.transmission.x = 0.8;
  EXPECT_NEAR(render_frame(darker, sliced(12)).depth[40], 0.3, 1e-4);
  Scene clear = seen;
  clear.surfaces[1] = pane(AlphaMode::blend, 0.25, glm::dvec3(0.0));
  clear.surfaces[1].translate.y = 0.6;
  clear.surfaces[1].material.metallic_roughness.base_color = glm::dvec3(0.0);
  const Frame through = render_frame(clear, sliced(12));
  EXPECT_NEAR(through.depth[40], 0.9, 1e-4);
  EXPECT_NEAR(mean_of(through).x / floor.x, 0.75, 0.02);  // its highlights
}

// In fog: beams, airlight before and behind, all orders.
TEST(CoverageFrames, PanesInFogAreThoseOfPaths) {
  for (const Surface& hung : {pane(AlphaMode::opaque, 1.0, {0.9, 0.4, 0.1}),
                              pane(AlphaMode::blend, 0.5, glm::dvec3(0.0))}) {
    Scene scene = on_film(in_fog(with(lit_from_above(), {hung}), 0.15), {12, 9});
    scene.optics.albedo = glm::dvec3(0.8);  // paths end sooner
    const Frame wanted = traced_truth(scene, 128);
    const Frame frame = render_frame(scene, all_orders(24));
    const Difference found = difference(frame.beauty, wanted.beauty);
    EXPECT_LT(std::abs(found.bias), 0.03);
    EXPECT_LT(found.relative_rmse, 0.08);
    Scene opaque = scene;
    opaque.surfaces.back().material.metallic_roughness.alpha = AlphaMode::opaque;
    opaque.surfaces.back().material.metallic_roughness.transmission = glm::dvec3(0.0);
    EXPECT_GT(rel_rmse(render_frame(opaque, path_traced(32)).beauty, wanted.beauty), 0.12);
  }
}

// A room with a dark window in bright fog, seen from within: the fog outside neither lights the
// window's near side nor shines through it more than it lets through.
TEST(CoverageFrames, WindowsKeepBrightFogOutOfRooms) {
  Scene scene = seen_by({{-1.5, 0, 0}, {2, 0, 0}, {0, 1, 0}, 50.0}, {10, 10});
  scene.medium.set_homogeneous_density(0.1);
  scene.lights = {{.intensity = {3, 3, 3}, .kind = light::Directional{{-1, -0.5, 0.2}, 0.0}}};
  for (const glm::dvec3& side :
       {glm::dvec3(0, -2, 0), {0, 2, 0}, {-2, 0, 0}, {0, 0, -2}, {0, 0, 2}, {2, 0, 0}}) {
    Surface wall = pane(AlphaMode::opaque, 1.0, glm::dvec3(0.0));
    wall.scale = 2.0;
    wall.translate = side;
    wall.rotate = glm::dquat(glm::dvec3(0, 1, 0), glm::normalize(side));
    wall.material.metallic_roughness.base_color = glm::dvec3(0.2);
    scene.surfaces.push_back(wall);
  }
  MetallicRoughness& window = scene.surfaces.back().material.metallic_roughness;
  window.base_color = glm::dvec3(1.0);
  window.transmission = glm::dvec3(0.03);
  const Frame wanted = traced_truth(scene, 512);
  const Frame frame = render_frame(scene, all_orders(24));
  const Difference found = difference(frame.beauty, wanted.beauty);
  EXPECT_LT(std::abs(found.bias), 0.04);  // 0.23 with nodes outside, 0.06 if edges count twice
  EXPECT_LT(found.relative_rmse, 0.1);    // of which paths' noise is 0.05
}

// Samples see through panes what whole frames of shifted films would.
TEST(CoverageFrames, SamplesOfPixelsSeeThroughPanes) {
  Surface glass = pane(AlphaMode::blend, 0.6, {0.9, 0.5, 0.1});
  glass.rotate = glm::angleAxis(1.2, glm::dvec3(0.6, 0.0, 0.8));
  Scene scene = in_fog(with(lit_from_above(), {glass, checkered_leaf()}), 0.15);
  scene.lights[0].position.y = 6.2;  // out of sight: around it pixels have samples by chance
  Settings settings = sliced(24);
  settings.samples = 16;
  Settings single = settings;
  single.samples = 1;
  const Frame wanted = *render_shifted(
      scene.film, settings, {}, [&](const Film& film, const Settings& one_sample, const Job&) {
        Scene shifted = scene;
        shifted.film = film;
        return std::optional<Frame>(render_frame(shifted, one_sample));
      });
  const Frame frame = render_frame(scene, settings);
  EXPECT_GT(frame.statistics.sampled_pixels, 100u);
  EXPECT_LT(frame.statistics.sampled_pixels, frame.depth.size());
  EXPECT_LT(rel_rmse(frame.beauty, wanted.beauty), 1e-3);
  // Pixels whose beauty has no details are one sample.
  EXPECT_LT(rel_rmse(frame.airlight, wanted.airlight), 6e-3);
  EXPECT_LT(rel_rmse(frame.transmittance, wanted.transmittance), 6e-3);
  EXPECT_GT(rel_rmse(render_frame(scene, single).beauty, wanted.beauty), 3e-3);
  settings.airlight_scale = 4;
  EXPECT_LT(rel_rmse(render_frame(scene, settings).beauty, wanted.beauty), 2e-3);
}

// Also in the middle of all surfaces, where coordinates have the most digits.
TEST(CoverageFrames, PanesAreSeenOnceEverywhere) {
  Scene scene = on_film(floor_from_above(), {41, 41});
  scene.camera = {{1.5, 1.0, 2.0}, {0, 0, 0}, {0, 1, 0}, 40.0};
  Surface veil = pane(AlphaMode::blend, 0.5, glm::dvec3(0.0));
  veil.material.metallic_roughness.base_color = glm::dvec3(0.0);
  veil.material.metallic_roughness.emissive = glm::dvec3(1.0);
  scene.surfaces = {veil};
  scene.lights.clear();
  const Frame frame = render_frame(scene, sliced(12));
  int seen = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (frame.beauty[4 * i] == 0.0f) continue;
    ++seen;
    EXPECT_EQ(frame.beauty[4 * i], 0.5f) << i;
  }
  EXPECT_GT(seen, 300);
}

TEST(CoverageFrames, StacksOfPanesDarkenWhatIsBehind) {
  std::vector<Surface> stack;
  for (int k = 0; k < 3; ++k) {
    stack.push_back(pane(AlphaMode::blend, 0.5, glm::dvec3(0.0)));
    stack.back().translate.y = -0.1 * k;
    stack.back().material.metallic_roughness.base_color = glm::dvec3(0.0);
  }
  const Scene plain = floor_from_above();
  const float share = mean_of(render_frame(with(plain, stack, 1.2), sliced(12))).x /
                      mean_of(render_frame(plain, sliced(12))).x;
  EXPECT_NEAR(share, 0.125, 1e-5);
}

// Holes and panes, as rays meet them.

constexpr glm::dvec3 down(0.0, -1.0, 0.0);

// A ray down onto a square of 2 u around the origin, at x and z.
SurfaceHit hit_from_above(const RayCaster& caster, double x, double z) {
  return caster.first_hit({x, 1.0, z}, down);
}

TEST(Coverage, RaysPassHoles) {
  const std::vector<Surface> leaf{checkered_leaf()};
  const RayCaster caster(leaf);
  std::vector<glm::dvec3> directions;
  std::vector<bool> are_there;
  int holes = 0;
  for (int z = 0; z < 8; ++z) {
    for (int x = 0; x < 8; ++x) {
      const double px = -0.875 + 0.25 * x;
      const double pz = -0.875 + 0.25 * z;
      const bool is_there = is_leaf_there(px, pz);
      holes += !is_there;
      EXPECT_EQ(static_cast<bool>(hit_from_above(caster, px, pz)), is_there) << px << ' ' << pz;
      EXPECT_EQ(caster.transmittance({px, 1, pz}, {px, -1, pz}), is_there ? 0.0 : 1.0);
      EXPECT_EQ(caster.occluded({px, 1, pz}, {px, -1, pz}), is_there);
      directions.push_back(glm::normalize(glm::dvec3(px, 0.0, pz) - glm::dvec3(0, 1, 0)));
      are_there.push_back(is_there);
    }
  }
  EXPECT_EQ(holes, 32);
  std::vector<SurfaceHit> hits(directions.size());  // in packets
  caster.first_hits({0, 1, 0}, directions, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(static_cast<bool>(hits[i]), are_there[i]) << i;
  }
}

TEST(Coverage, CutoffAndOpacityMoveTheEdgesOfHoles) {
  Surface leaf = checkered_leaf();
  MetallicRoughness& material = leaf.material.metallic_roughness;
  const auto is_there = [&] {
    return static_cast<bool>(hit_from_above(RayCaster(std::span(&leaf, 1)), 0.25, 0.75));
  };
  ASSERT_TRUE(is_there());
  material.opacity = 0.4;
  EXPECT_FALSE(is_there());
  material.alpha_cutoff = 0.4;
  EXPECT_TRUE(is_there());
  material.opacity = 0.0;
  material.alpha = AlphaMode::opaque;
  EXPECT_TRUE(is_there());
}

TEST(Coverage, RayCastersAreOfTheirHolesAndPanes) {
  const std::vector<Surface> before{checkered_leaf()};
  const RayCaster caster(before);
  EXPECT_TRUE(caster.shows(before));
  const auto shows_with = [&](auto&& change) {
    std::vector<Surface> surfaces = before;
    change(surfaces[0].material.metallic_roughness);
    return caster.shows(surfaces);
  };
  EXPECT_TRUE(shows_with([](MetallicRoughness& m) { m.base_color = glm::dvec3(0.1); }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.alpha = AlphaMode::opaque; }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.alpha_cutoff = 0.1; }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.opacity = 0.1; }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.transmission.x = 0.1; }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.base_color_texture = {}; }));
}

TEST(Coverage, PanesAttenuate) {
  // From above: a quarter covered, half and all of red transmitted, an opaque floor.
  std::vector<Surface> panes{pane(AlphaMode::blend, 0.25, glm::dvec3(0.0)),
                             pane(AlphaMode::opaque, 1.0, {1.0, 0.5, 0.0}), checkered_leaf()};
  panes[2].material.metallic_roughness.alpha = AlphaMode::opaque;
  panes[0].translate.y = 2.0;
  panes[1].translate.y = 1.0;
  const glm::dvec3 start(0.3, 3.0, 0.1);
  const std::array<double, 3> second{1.0, 0.5, 0.0};
  for (int c = 0; c < 3; ++c) {
    glm::dvec3 channel(0.0);
    channel[c] = 1.0;
    const RayCaster caster(panes, channel);
    EXPECT_TRUE(caster.has_panes());
    const double both = 0.75 * second[static_cast<std::size_t>(c)];
    EXPECT_FLOAT_EQ(caster.transmittance(start, {0.3, 0.5, 0.1}), both);
    EXPECT_NEAR(caster.transmittance(start, down, 2.5), both, 1e-7);
    EXPECT_EQ(caster.transmittance(start, down, 3.5), 0.0);
    const HitsOnRay hits = caster.hits_on_ray(start, down);
    ASSERT_EQ(hits.panes.size(), 2u);
    EXPECT_EQ(hits.panes[0].hit.surface, 0);
    EXPECT_EQ(hits.panes[1].hit.surface, 1);
    EXPECT_EQ(hits.end.surface, 2);
    EXPECT_NEAR(hits.passing(1.5), 0.75, 1e-12);
    EXPECT_EQ(caster.next_hit(start, down, hits.panes[0].hit).surface, 1);
    EXPECT_EQ(caster.next_hit(start, down, hits.panes[1].hit).surface, 2);
    std::array<SurfaceHit, 1> opaque;
    caster.opaque_hits(start, std::array{down}, opaque, 0.0);
    EXPECT_EQ(opaque[0].surface, 2);
    // Rays stopped by chance: as many as light.
    double draw = 0.0;
    int stopped = 0;
    for (int k = 0; k < 100; ++k) {
      draw = (k + 0.5) / 100.0;
      stopped += caster.first_hit_by_chance(start, down, [&] { return draw; }).surface == 0;
    }
    EXPECT_EQ(stopped, 25);
  }
  EXPECT_EQ(RayCaster(panes).pane(RayCaster(panes).first_hit(start, down), 0.0).opaque, 0.25);
  EXPECT_FALSE(RayCaster(panes).shows(panes, {1, 0, 0}));
}

TEST(Coverage, IsOfMetallicRoughnessAlone) {
  Surface surface = checkered_leaf();
  surface.material.type = Material::Type::diffuse;
  EXPECT_TRUE(Coverage(surface.material).is_opaque());
  EXPECT_FALSE(has_holes(std::span(&surface, 1)));
  surface.material.type = Material::Type::metallic_roughness;
  EXPECT_TRUE(has_holes(std::span(&surface, 1)));
}

}  // namespace

}  // namespace brume
