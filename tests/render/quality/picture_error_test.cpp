// Errors of whole pictures, with their surfaces, beside all the light that there is.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "render/quality/auto_quality.h"
#include "render/quality/center_light.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// A floor in thin fog, seen from above, as yet without light.
Scene dark_stage() {
  Scene scene;
  scene.surfaces.push_back(placed(Primitive::Shape::box, {6.0, 0.2, 6.0}, {0.0, -0.1, 0.0}));
  scene.surfaces.front().material.reflectance = glm::dvec3(0.6);
  scene.camera.eye = {0.0, 2.5, 5.0};
  scene.camera.target = {0.0, 0.6, 0.0};
  scene.film = {10, 8};
  scene.optics.albedo = glm::dvec3(0.8);  // paths end sooner
  return in_fog(std::move(scene), 0.08);
}

Settings paths_of(int count) {
  Settings settings;
  settings.airlight = AirlightMethod::path;
  settings.paths = count;
  return settings;
}

// The relative RMSE of a frame's picture beside another.
double rel_rmse(const Frame& frame, const Frame& truth) {
  const CenterLight wrong = CenterLight::picture(frame);
  const CenterLight right = CenterLight::picture(truth);
  double error = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < right.pixels(); ++i) {
    const glm::dvec3 difference = wrong.at(i) - right.at(i);
    error += glm::dot(difference, difference);
    sum += right.square(i);
  }
  return std::sqrt(error / sum);
}

FrameError measured_error(const Scene& scene, const Frame& frame) {
  FrameErrors errors(scene, scene.camera, evaluation_seed, Measured::airlight_and_picture);
  return *errors.measure_within(2e8, frame, std::nullopt);
}

Surface of_material(Surface surface, const MetallicRoughness& material) {
  surface.material.type = Material::Type::metallic_roughness;
  surface.material.metallic_roughness = material;
  return surface;
}

Environment white_sky() {
  Environment sky;
  sky.map = constant_sky(1.0f);
  return sky;
}

struct LitScene {
  std::string name;
  Scene scene;
};

// Each kind of light alone.
std::vector<LitScene> kinds_of_light() {
  std::vector<LitScene> scenes;
  const auto add_light = [&](const char* name, const Light::Kind& kind, double intensity) {
    Scene scene = dark_stage();
    scene.lights = {
        {.position = {0.4, 1.5, 0.2}, .intensity = glm::dvec3(intensity), .kind = kind}};
    scenes.push_back({name, std::move(scene)});
  };
  add_light("point", light::Point{}, 3.0);
  add_light("spot", light::Spot{.inner_angle = 20.0, .outer_angle = 30.0}, 5.0);
  add_light("sun", light::Directional{.direction = {0.3, -1.0, -0.2}}, 2.0);
  add_light("rectangle", light::Rectangle{.up = {0.0, 0.0, 1.0}}, 4.0);
  add_light("disk", light::Disk{}, 4.0);
  add_light("sphere", light::Sphere{.radius = 0.3}, 4.0);
  const auto add = [&](const char* name, auto change) {
    Scene scene = dark_stage();
    change(scene);
    scenes.push_back({name, std::move(scene)});
  };
  add("sky", [](Scene& scene) { scene.environment = white_sky(); });
  add("emissive surface", [](Scene& scene) {
    MetallicRoughness shining;
    shining.emissive = glm::dvec3(3.0);
    scene.surfaces.push_back(
        of_material(placed(Primitive::Shape::box, {1.5, 0.4, 0.4}, {0.0, 1.2, 0.0}), shining));
  });
  add("flame", [](Scene& scene) {
    Gaussian flame{.center = {0.0, 0.8, 0.0}, .radius = 0.3, .density = 2.0};
    flame.optics.emission = glm::dvec3(2.0);
    scene.medium.append(flame);
  });
  return scenes;
}

// A picture of no light at all is wrong by all of it, whatever the light comes from.
TEST(PictureErrors, EveryKindOfLightIsMissedWhereItIsLeftOut) {
  for (const LitScene& lit : kinds_of_light()) {
    Frame frame = render_frame(lit.scene, paths_of(16));
    std::ranges::fill(frame.beauty, 0.0f);
    std::ranges::fill(frame.airlight, 0.0f);
    const FrameError error = measured_error(lit.scene, frame);
    ASSERT_TRUE(error.picture) << lit.name;
    EXPECT_NEAR(error.picture->rel_rmse, 1.0, 1e-6) << lit.name;
  }
}

// The paper's method leaves light out: that is in the error of its pictures, too.
TEST(PictureErrors, TheIntervalHasWhatAPathTracedPictureTells) {
  for (const LitScene& lit : kinds_of_light()) {
    // The others are like these.
    if (lit.name == "spot" || lit.name == "disk" || lit.name == "sphere" || lit.name == "sun")
      continue;
    const Frame truth = render_frame(lit.scene, paths_of(256));
    const double noise = relative_noise(truth)->picture;
    for (const AirlightMethod method : {AirlightMethod::paper, AirlightMethod::sliced}) {
      Settings settings = all_orders(Settings().slices);
      settings.airlight = method;
      const Frame frame = render_frame(lit.scene, settings);
      const ErrorEstimate error = *measured_error(lit.scene, frame).picture;
      const double actual = rel_rmse(frame, truth);
      const std::string name = lit.name + ", " + airlight_name(settings);
      EXPECT_LE(error.low, actual + noise) << name;
      EXPECT_GE(error.high, actual - noise) << name;
      const double widest = method == AirlightMethod::sliced ? 0.4 : 2.0;
      EXPECT_LT(error.high - error.low, widest) << name;
    }
  }
}

// Behind panes light comes from several surfaces, and from the sky behind all.
TEST(PictureErrors, SeeThroughPanesToTheSky) {
  Scene scene = dark_stage();
  scene.environment = white_sky();
  MetallicRoughness glass;
  glass.transmission = {0.9, 0.5, 0.2};
  scene.surfaces.push_back(
      of_material(placed(Primitive::Shape::box, {2.0, 2.0, 0.02}, {0.0, 1.0, 1.0}), glass));
  const Frame frame = render_frame(scene, paths_of(1024));
  const ErrorEstimate right = *measured_error(scene, frame).picture;
  EXPECT_LT(right.rel_rmse, 0.05);
  EXPECT_EQ(right.low, 0.0);
  Frame dim = frame;
  for (float& value : dim.beauty) value *= 0.8f;
  const ErrorEstimate wrong = *measured_error(scene, dim).picture;
  EXPECT_NEAR(wrong.rel_rmse, 0.2, 0.05);
}

// Mirrors show the shapes of lights, in the picture and in what it is compared with.
TEST(PictureErrors, HaveVisibleLightsInMirrors) {
  Scene scene = dark_stage();
  MetallicRoughness brass;
  brass.roughness = 0.1;
  scene.surfaces[0] = of_material(scene.surfaces[0], brass);
  scene.lights = {
      {.position = {0.0, 1.0, -1.0},
       .intensity = glm::dvec3(0.05),
       .kind = light::Rectangle{
           .direction = {0.0, 0.0, 1.0}, .width = 3.0, .height = 2.0, .visible = true}}};
  MetallicRoughness shining;
  shining.emissive = glm::dvec3(1.0);
  scene.surfaces.push_back(
      of_material(placed(Primitive::Shape::box, {6.0, 4.0, 0.1}, {0.0, 2.0, -2.0}), shining));
  const ErrorEstimate error = *measured_error(scene, render_frame(scene, paths_of(256))).picture;
  EXPECT_LT(error.rel_rmse, 0.1);
}

// The sky behind the fog is a part of the picture alone.
TEST(PictureErrors, HaveTheSkyBehindTheFog) {
  Scene scene = on_film(cloud_scene(30, 1.0), {16, 12});
  scene.environment = white_sky();
  const Settings settings = all_orders(24);
  Frame frame = render_frame(scene, settings);
  EXPECT_LT(measured_error(scene, frame).picture->high, 0.05);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) frame.beauty[4 * i + c] = frame.airlight[3 * i + c];
  }
  EXPECT_GT(measured_error(scene, frame).picture->low, 0.3);
}

// Filtered pixels are judged by their centers, as those of the airlight are.
TEST(PictureErrors, OfFilteredPixelsAreThoseOfTheirCenters) {
  Scene scene = dark_stage();
  scene.lights = {{.position = {0.4, 1.5, 0.2}, .intensity = glm::dvec3(3.0)}};
  Settings settings = sliced_settings({}, 24);
  const Frame once = render_frame(scene, settings);
  settings.samples = 16;
  const Frame filtered = render_frame(scene, settings);
  EXPECT_EQ(filtered.beauty_at_centers, once.beauty);
  EXPECT_EQ(measured_error(scene, filtered).picture->rel_rmse,
            measured_error(scene, once).picture->rel_rmse);
}

}  // namespace
}  // namespace brume
