// Light scattered more than once, on the device and on the CPU.

#include <gtest/gtest.h>

#include "core/scene/fields/light_fields.h"
#include "tests/pictures.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_profiles.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume::gl {
namespace {

// Both backends look the same grid up; surfaces hide nodes from each other.
TEST_F(GlFrames, MultipleScattering) {
  for (const double anisotropy : {0.0, 0.6, 0.85}) {
    Scene scene = on_film(cloud_scene(10, 3.0), {16, 12});
    scene.optics.anisotropy = anisotropy;
    scene.optics.albedo = glm::dvec3(0.9);
    Settings settings = quick_slices();
    settings.source_grid = {2000, 24};
    settings.scattering = Scattering::multiple;
    for (const bool has_more : {false, true}) {
      const std::string name =
          "g = " + std::to_string(anisotropy) + (has_more ? ", sky and wall" : "");
      if (has_more) {
        scene.environment.emplace().map = smooth_sky();
        scene.surfaces.push_back(wall(0.1, 0.8));
      }
      const Frame cpu = render_frame(scene, settings);
      const Frame gl = render_on_device(scene, settings, name);
      // The backends may differ by this.
      EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 2e-3) << name;
      EXPECT_LE(rel_rmse(gl.beauty, cpu.beauty), 2e-3) << name;
      ASSERT_TRUE(gl.statistics.scattering) << name;
    }
  }
}

// A sky's light that the forward lobe scatters: in fog along view rays, beside surfaces as nodes
// hold it.
TEST_F(GlFrames, ForwardLobes) {
  for (const double anisotropy : {-0.6, 0.6, 0.9}) {
    for (const bool has_wall : {false, true}) {
      Scene scene = on_film(in_fog(cloud_scene(10, 2.0), 0.05), {16, 12});
      scene.optics.anisotropy = anisotropy;
      scene.environment.emplace().map = smooth_sky();
      if (has_wall) scene.surfaces = {wall(-0.8, 1.5)};
      for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
        expect_backends_agree(scene, scattering);
      }
    }
  }
}

// Beams in the medium and on surfaces, lights with profiles, a picture in a beam.
TEST_F(GlFrames, LightsInFogBeforeAWall) {
  std::vector<Light> profiles{
      {{0.9, 1.4, 0.6}, glm::dvec3(6.0), light::Spot{{-0.9, -1.4, -0.9}, 25.0, 40.0}},
      {{-0.3, 1.0, 0.7}, {2.0, 3.0, 4.0}},
      {{0.5, 0.5, 1.5}, glm::dvec3(1.0)},
      {{0.6, 1.0, 0.0}, glm::dvec3(1.0)}};
  *profile_member(profiles[0]) = lobed_profile(70.0);
  *profile_member(profiles[1]) = cosine_profile();
  *profile_member(profiles[3]) = *profile_member(profiles[1]);
  std::vector<Light> picture{profiles[0], profiles[1]};
  *profile_member(picture[0]) = {};
  picture[0].as<light::Spot>()->texture = {
      .file = "a.png", .content = quadrants_picture(), .rotation = 30.0};
  const std::vector<Light> spots{
      {{0.9, 1.4, 0.6}, glm::dvec3(6.0), light::Spot{{-0.9, -1.4, -0.9}, 5.0, 20.0}},
      {{-1.0, 0.4, 1.0}, glm::dvec3(2.0), light::Spot{{1.0, -0.3, -1.2}, 9.8, 10.0}},
      {{0.0, -1.0, 0.5}, glm::dvec3(1.0), light::Spot{{0.0, 1.0, 0.0}, 60.0, 130.0}},
      {{1.0, 0.4, 1.0}, glm::dvec3(9.0), light::Spot{{-1.0, -0.3, -1.2}, 0.5, 1.0}},
      {{0.5, 0.5, 1.5}, glm::dvec3(1.0), {}}};
  for (const auto& [name, lights] :
       {std::pair("spots", spots), {"profiles", profiles}, {"a picture and a profile", picture}}) {
    SCOPED_TRACE(name);
    for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
      Scene scene = on_film(in_fog(cloud_scene(10, 2.0), 0.02), {24, 18});
      scene.surfaces.push_back(wall(-0.8, 1.5));
      scene.lights = lights;
      expect_backends_agree(scene, scattering);
    }
  }
}

TEST_F(GlFrames, GaussiansWithOptics) {
  for (const double b0 : {0.0, 0.05}) {
    for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
      Scene scene = on_film(in_fog(cloud_scene(10, 2.0), b0), {24, 18});
      scene.surfaces = {wall(-0.8, 1.5)};
      scene.optics.anisotropy = b0 > 0.0 ? 0.5 : 0.0;
      std::size_t index = 0;
      scene.medium = scene.medium.changed(b0, [&index](Gaussian g) {
        if (index % 3 == 0) g.optics.albedo = {0.9, 0.3, 0.2};
        if (index++ % 4 == 0) g.optics.emission = {3.0, 1.0, 0.2};
        return g;
      });
      expect_backends_agree(scene, scattering);
    }
  }
}

TEST_F(GlFrames, AreaLights) {
  for (const double b0 : {0.0, 0.05}) {
    for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
      Scene scene = on_film(in_fog(cloud_scene(10, 2.0), b0), {24, 18});
      scene.surfaces = {wall(-0.8, 1.5), wall(0.0, 0.4)};
      scene.surfaces[1].translate = {0.5, 1.0, 0.3};
      scene.lights = {
          {{1.5, 1.5, 1.0}, {3.0, 2.0, 1.0}, light::Rectangle{.direction = {-1.0, -1.0, -0.7}}},
          {{-1.5, 0.5, 0.5}, glm::dvec3(2.0), light::Disk{{1.0, 0.1, -0.3}, 0.3, true}},
          {{0.0, -1.0, 0.5}, glm::dvec3(1.0), light::Sphere()}};
      // Two of them: a software device ends shaders that go through some 900 lights and slices.
      scene.lights.erase(scene.lights.begin() + (scattering == Scattering::single ? 0 : 1));
      expect_backends_agree(scene, scattering);
    }
  }
}

TEST_F(GlFrames, DirectionalLights) {
  for (const double b0 : {0.0, 0.05}) {
    for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
      Scene scene = on_film(in_fog(cloud_scene(10, 2.0), b0), {24, 18});
      // One shades the medium and the other.
      scene.surfaces = {wall(-0.8, 1.5), wall(0.0, 0.4)};
      scene.surfaces[1].translate = {0.5, 1.0, 0.3};
      scene.lights = {
          {.intensity = {3.0, 2.0, 1.0}, .kind = light::Directional{{-0.9, -1.4, -0.9}}},
          {.intensity = glm::dvec3(0.5), .kind = light::Directional{{1.0, 0.2, -0.4}, 3.0}},
          {{0.5, 0.5, 1.5}, glm::dvec3(1.0)}};
      expect_backends_agree(scene, scattering);
    }
  }
}

}  // namespace
}  // namespace brume::gl
