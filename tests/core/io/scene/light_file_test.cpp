// Lights of scene files: what they are when they are read again.

#include <gtest/gtest.h>

#include <memory>

#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/photometric_profile.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

using LightsInFiles = FolderTest;

// `on` came later than other programs that read scenes: it is written only where it says something.
TEST_F(LightsInFiles, SayWhetherTheyAreOff) {
  Scene scene;
  scene.lights = {{.position = {1, 2, 3}, .on = true}, {.position = {1, 2, 3}, .on = false}};
  save_document(scene, folder_ / "a.brume");
  const Scene loaded = load_scene(folder_ / "a.brume");
  EXPECT_TRUE(loaded.lights[0].on);
  EXPECT_FALSE(loaded.lights[1].on);
  const std::string text = content_of(folder_ / "a.brume");
  EXPECT_TRUE(contains(text, R"("on": false)"));
  EXPECT_FALSE(contains(text, R"("on": true)"));
}

// Other programs read these words.
TEST_F(LightsInFiles, HaveTheUnitsOfTheirKinds) {
  Scene scene;
  scene.lights = {{.intensity = {4, 5, 6}, .kind = light::Directional{{1, -2, 0}, 0.53}}};
  save_document(scene, folder_ / "a.brume");
  const std::string sun = content_of(folder_ / "a.brume");
  EXPECT_TRUE(contains(sun, R"("irradiance": [4.0, 5.0, 6.0])"));
  EXPECT_FALSE(contains(sun, "position"));
}

TEST_F(LightsInFiles, SayWhetherTheyAreVisible) {
  Scene scene;
  scene.lights = {{.kind = light::Rectangle{.visible = true}},
                  {.kind = light::Disk{.visible = true}},
                  {.kind = light::Sphere{.visible = true}},
                  {.kind = light::Sphere{}}};
  save_document(scene, folder_ / "a.brume");
  const Scene loaded = load_scene(folder_ / "a.brume");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(loaded.lights[i].kind, scene.lights[i].kind);
  const std::string text = content_of(folder_ / "a.brume");
  EXPECT_TRUE(contains(text, R"("visible": true)"));
  EXPECT_FALSE(contains(text, R"("visible": false)"));
  // A light without a shape has no such key: it is kept, and named in a warning.
  folder_.write_scene("point.brume", R"("lights": [
    { "type": "point", "position": [0, 0, 0], "visible": true }])");
  std::vector<std::string> warnings;
  load_document(folder_ / "point.brume", &warnings);
  expect_only(warnings, "lights[].visible: unknown key");
  folder_.write_scene("number.brume", R"("lights": [
    { "type": "sphere", "position": [0, 0, 0], "radius": 1, "radiance": 1, "visible": 1 }])");
  expect_error([&] { load_scene(folder_ / "number.brume"); }, "lights[0].");
}

TEST_F(LightsInFiles, KeepProfiles) {
  folder_.write("narrow.ies", "TILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 60\n0 30\n0\n100 0\n");
  Scene scene;
  scene.lights = {{{1, 2, 3}, {4, 5, 6}, light::Spot{{0, -2, 1}, 12.5, 30}},
                  {{3, 2, 1}, {1, 1, 1}}};
  const auto content = std::make_shared<const PhotometricProfile>(PhotometricProfile::isotropic());
  *profile_member(scene.lights[0]) = {folder_ / "narrow.ies", content, 30.0};
  *profile_member(scene.lights[1]) = {folder_ / "narrow.ies", content, 0.0};
  scene.lights[1].keys.profile_rotation = {{0.0, 20.0}, {2.0, 400.0}};
  save_document(scene, folder_ / "a.brume");
  EXPECT_TRUE(contains(content_of(folder_ / "a.brume"), R"("profile": "narrow.ies")"));
  const Scene loaded = load_scene(folder_ / "a.brume");
  ASSERT_EQ(loaded.lights.size(), 2u);
  EXPECT_TRUE(loaded.lights[0].as<light::Spot>());
  EXPECT_EQ(profile_member(loaded.lights[0])->rotation, 30.0);
  EXPECT_EQ(profile_member(loaded.lights[0])->file, folder_ / "narrow.ies");
  EXPECT_LT(profile_member(loaded.lights[0])->content->solid_angle(), 1.0);
  EXPECT_EQ(profile_member(loaded.lights[1])->content, profile_member(loaded.lights[0])->content);
  EXPECT_EQ(loaded.lights[1].keys, scene.lights[1].keys);
  // Where it is missing, the light shines in all directions, and keeps its name.
  std::filesystem::remove(folder_ / "narrow.ies");
  MissingFiles missing;
  const Scene without = load_document(folder_ / "a.brume", nullptr, missing).scene;
  EXPECT_EQ(missing.missing.size(), 1u);
  EXPECT_EQ(profile_member(without.lights[0])->content->at({1, 0, 0}), 1.0);
  save_document(without, folder_ / "b.brume");
  EXPECT_TRUE(contains(content_of(folder_ / "b.brume"), R"("profile": "narrow.ies")"));
  expect_error([&] { load_scene(folder_ / "a.brume"); }, "lights[0].profile");
}

// Saved where keyframes have closed the cone: what they are at a moment refuses no file.
TEST_F(LightsInFiles, LoadWithKeyedConesAtAnyMoment) {
  Scene scene;
  scene.lights = {{{1, 2, 3}, {4, 5, 6}, light::Spot{{0, 0, 0}, 30, 20}}};
  LightKeys& keys = scene.lights[0].keys;
  keys.outer_angle = {{0.0, 20.0}, {2.0, 40.0}};
  keys.direction = {{0.0, {0, 1, 0}}, {1.0, {0, -1, 0}}};
  save_document(scene, folder_ / "a.brume");
  EXPECT_EQ(load_scene(folder_ / "a.brume").lights[0].kind, scene.lights[0].kind);
  keys.direction = {};
  save_document(scene, folder_ / "a.brume");
  EXPECT_THROW(load_scene(folder_ / "a.brume"), InputError);
}

TEST_F(LightsInFiles, HaveTheDocumentedCones) {
  folder_.write_scene(
      "a.brume", R"("lights": [{"type": "spot", "position": [0, 1, 0], "direction": [0, -1, 0]}])");
  const Scene scene = load_scene(folder_ / "a.brume");
  ASSERT_TRUE(scene.lights.at(0).as<light::Spot>());
  EXPECT_EQ(scene.lights[0].as<light::Spot>()->inner_angle, 0.0);
  EXPECT_EQ(scene.lights[0].as<light::Spot>()->outer_angle, 45.0);
}

}  // namespace
}  // namespace brume
