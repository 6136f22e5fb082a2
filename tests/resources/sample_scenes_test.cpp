// The sample scenes and templates load, and they hold what the manual says.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>

#include "brume/at_time.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/copies.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/emitting_surfaces.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/mesh.h"
#include "core/transport/medium_summary.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

const fs::path scenes = BRUME_SCENES;

Scene load(const fs::path& name) {
  std::vector<std::string> warnings;
  Scene scene = load_scene(scenes / name, &warnings);
  EXPECT_TRUE(warnings.empty()) << name << ": " << warnings.front();
  EXPECT_EQ(scene.film, (Film{800, 600})) << name;
  EXPECT_TRUE(!scene.lights.empty() || scene.environment) << name;
  return scene;
}

// b(x) of the medium [1/u].
double density_at(const Medium& medium, const glm::dvec3& point) {
  double sum = medium.homogeneous_density();
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const Gaussian g = medium.gaussian(i);
    const double distance = glm::distance(point, g.center) / g.radius;
    sum += g.density * std::exp(-distance * distance);
  }
  return sum;
}

TEST(SampleScenes, EachLoadsWithoutWarnings) {
  for (const fs::path& folder : {scenes, fs::path(BRUME_TEMPLATES)}) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".brume") continue;
      const Scene scene = load(entry.path());
      EXPECT_TRUE(!scene.medium.empty() || folder != scenes) << entry.path();
    }
  }
}

TEST(SampleScenes, SprucesAreCopiesOfOne) {
  const Scene scene = load("spruces.brume");
  const std::vector<Surface> placed = with_placed_copies(scene.surfaces);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_EQ(placed[0].placed_copies, nullptr);
  ASSERT_NE(placed[1].placed_copies, nullptr);
  EXPECT_EQ(placed[1].placed_copies->size(), 3234u) << "README.md says it";
  EXPECT_EQ(placed[1].mesh->n_faces(), 1815u);
}

TEST(SampleScenes, BunnyInFog) {
  const Scene scene = load("bunny_fog.brume");
  EXPECT_EQ(scene.medium.size(), 34u);
  EXPECT_EQ(scene.lights.size(), 3u);
  ASSERT_EQ(scene.surfaces.size(), 2u);
  EXPECT_EQ(scene.surfaces[0].mesh->n_vertices(), 1839u);
}

TEST(SampleScenes, TeapotWithSteam) {
  const Scene scene = load("teapot_steam.brume");
  EXPECT_EQ(scene.lights.size(), 2u);
  EXPECT_GT(scene.medium.homogeneous_density(), 0.0);
  EXPECT_LT(scene.medium.homogeneous_density(), 0.02);
}

TEST(SampleScenes, BoxOfSmallGaussians) {
  const Scene scene = load("box_3008.brume");
  EXPECT_EQ(scene.medium.size(), 3008u);
  EXPECT_EQ(scene.lights.size(), 1u);
  const auto radii = scene.medium.radii();
  EXPECT_LT(*std::max_element(radii.begin(), radii.end()), 0.15);
}

TEST(SampleScenes, GroundFogOverTerrain) {
  const Scene scene = load("ground_fog.brume");
  EXPECT_EQ(scene.medium.size(), 292u);
  ASSERT_EQ(scene.surfaces.size(), 1u);
  EXPECT_EQ(scene.surfaces[0].mesh->n_vertices(), 65536u);
  EXPECT_EQ(scene.surfaces[0].mesh->n_faces(), 2u * 255u * 255u);
  EXPECT_LT(fs::file_size(scenes / "terrain.ply"), 2'600'000u);
}

TEST(SampleScenes, CourtShadowsAndLightsItself) {
  const Scene scene = load("courtyard.brume");
  ASSERT_EQ(scene.surfaces.size(), 2u);
  for (const Surface& surface : scene.surfaces) {
    EXPECT_EQ(surface.transfer, Surface::Transfer::interreflection);
  }
  EXPECT_EQ(scene.surfaces[0].mesh->n_vertices(), 15'315u);
  ASSERT_TRUE(scene.environment);
  EXPECT_LT(fs::file_size(scenes / "courtyard.ply"), 500'000u);
}

TEST(SampleScenes, SunbeamsBetweenTrees) {
  const Scene scene = load("forest.brume");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_TRUE(scene.lights[0].as<light::Directional>());
  ASSERT_EQ(scene.surfaces.size(), 3u);
  EXPECT_LT(fs::file_size(scenes / "forest_leaves.ply"), 1'000'000u);
}

TEST(SampleScenes, HeadlightsOnAWetRoad) {
  const Scene scene = load("headlights.brume");
  ASSERT_EQ(scene.lights.size(), 5u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(scene.lights[k].as<light::Spot>());
  EXPECT_TRUE(scene.lights[4].as<light::Rectangle>());
  EXPECT_EQ(scene.surfaces[0].material.type, Material::Type::phong);
}

TEST(SampleScenes, AWetStreetUnderNeon) {
  const Scene scene = load("wet_street.brume");
  EXPECT_EQ(scene.surfaces.size(), 16u);
  EXPECT_EQ(std::ranges::count_if(scene.surfaces, is_emissive), 10);
  EXPECT_LT(scene.surfaces[0].material.metallic_roughness.roughness, 0.2) << "it is wet";
}

TEST(SampleScenes, AChapelWithStainedGlass) {
  const Scene scene = load("chapel.brume");
  EXPECT_EQ(
      std::ranges::count_if(scene.surfaces,
                            [](const Surface& surface) {
                              return static_cast<bool>(
                                  surface.material.metallic_roughness.transmission_texture.content);
                            }),
      3);
}

TEST(SampleScenes, PicturesInTheBeamsOfAStage) {
  const Scene scene = load("gobos.brume");
  ASSERT_EQ(scene.lights.size(), 3u);
  for (const Light& light : scene.lights) {
    EXPECT_TRUE(light.as<light::Spot>()->texture.content) << light.name;
  }
}

TEST(SampleScenes, ACandleAndItsSmoke) {
  const Scene scene = load("candle.brume");
  EXPECT_TRUE(scene.medium.has_emission());
  EXPECT_TRUE(scene.medium.has_albedos());
  EXPECT_EQ(scene.surfaces.size(), 3u);
}

TEST(SampleScenes, AHarbourOfColouredLights) {
  const Scene scene = load("harbour.brume");
  ASSERT_EQ(scene.lights.size(), 11u);
  for (std::size_t k = 0; k < 3; ++k) {
    const LightProfile* profile = profile_of(scene.lights[k]);
    ASSERT_TRUE(profile);
    EXPECT_LT(profile->content->solid_angle(), 5.0);
  }
  EXPECT_TRUE(scene.medium.has_emission());
  EXPECT_EQ(scene.surfaces[0].material.type, Material::Type::phong);
}

// Lines through every centre in 500 directions of a spiral.
TEST(SampleScenes, DenseCloudHasOpticalDepthTen) {
  const Medium medium = load("dense_cloud.brume").medium;
  ASSERT_EQ(medium.size(), 300u);
  const double golden_angle = 2.399963229728653;
  double max_value = 0.0;
  for (int k = 0; k < 500; ++k) {
    const double z = (k + 0.5) / 500.0;  // a half sphere: a line has no sign
    const double r = std::sqrt(1.0 - z * z);
    const glm::dvec3 direction(r * std::cos(golden_angle * k), r * std::sin(golden_angle * k), z);
    for (std::size_t i = 0; i < medium.size(); ++i) {
      double depth = 0.0;
      for (std::size_t j = 0; j < medium.size(); ++j) {
        const Gaussian g = medium.gaussian(j);
        const double h =
            glm::length(glm::cross(g.center - medium.centers()[i], direction)) / g.radius;
        depth += g.density * g.radius * std::exp(-h * h);
      }
      max_value = std::max(max_value, depth * std::sqrt(3.141592653589793));
    }
  }
  // No line through a centre is deeper than the deepest line, and some come close.
  EXPECT_LE(max_value, 10.01);
  EXPECT_GT(max_value, 9.8);
  EXPECT_NEAR(summarize(medium).max_optical_depth, 10.0, 0.01);
}

TEST(SampleScenes, LightAndCameraInside) {
  const Scene light_inside = load("light_inside.brume");
  ASSERT_EQ(light_inside.medium.size(), 1u);
  const Gaussian g = light_inside.medium.gaussian(0);
  EXPECT_LT(glm::distance(light_inside.lights.front().position, g.center), g.radius);

  const Scene camera_inside = load("camera_inside.brume");
  EXPECT_GT(camera_inside.medium.homogeneous_density(), 0.0);
  EXPECT_GT(density_at(camera_inside.medium, camera_inside.camera.eye),
            2.0 * camera_inside.medium.homogeneous_density());
}

TEST(SampleScenes, EveningMistHasAnEnvironment) {
  const Scene scene = load("evening_mist.brume");
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->map->width, 512);
  ASSERT_EQ(scene.surfaces.size(), 3u);
  EXPECT_EQ(scene.surfaces[1].material.type, Material::Type::phong);
}

TEST(SampleScenes, SunriseIsADayOfASky) {
  const Scene scene = load("sunrise.brume");
  ASSERT_TRUE(scene.environment && scene.environment->sky);
  EXPECT_EQ(last_moment(scene), 8.0);
  const Scene morning = evaluate_at(scene, 0.0);
  const Scene noon = evaluate_at(scene, 239.0 / 30.0);
  ASSERT_EQ(morning.lights.size(), 1U);
  EXPECT_GT(morning.lights[0].intensity.r, 5.0 * morning.lights[0].intensity.g);
  EXPECT_LT(noon.lights[0].intensity.r, 1.5 * noon.lights[0].intensity.g);
  const glm::dvec3 place(0.0, 0.5, -5.0);
  EXPECT_LT(density_at(noon.medium, place), 0.05 * density_at(morning.medium, place));
}

}  // namespace
}  // namespace brume
