// A region of a film has the bits that its pixels have in the picture of the whole film. A failure
// names its seed; BRUME_REGION_SEED=n tries that scene alone.

#include "tests/render/regions.h"

#include <gtest/gtest.h>

#include "brume/render.h"
#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

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

}  // namespace
}  // namespace brume
