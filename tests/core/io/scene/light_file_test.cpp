// Lights of scene files: what they are when they are read again.

#include <gtest/gtest.h>

#include <memory>

#include "core/io/image/image_file.h"
#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/materials/texture.h"
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

namespace fs = std::filesystem;

class MaterialFile : public FolderTest {
 protected:
  fs::path write(const std::string& material) {
    return folder_.write("a.brume", R"({"format": "brume-scene", "version": 1, "surfaces": [
      {"primitive": {"type": "box"}, "material": )" +
                                        material + "}]}");
  }
  std::string error(const std::string& material) {
    return error_of([&] { load_document(write(material)); });
  }

  const fs::path wood_ =
      folder_.write("wood.png", encode_png(2, 1, std::vector<std::uint8_t>{255, 0, 0, 0, 0, 255}));
};

TEST_F(MaterialFile, KeepsMetallicRoughness) {
  const fs::path file = write(R"({ "type": "metallic_roughness",
    "base_color": [1, 0.5, 0.25], "metallic": 0.25, "roughness": 0.75, "emissive": [0, 2, 30],
    "normal_scale": 0.5, "later": 1, "alpha": "cutout", "opacity": 0.75, "alpha_cutoff": 0.25,
    "transmission": [0.5, 0.25, 1], "transmission_texture": { "file": "wood.png" },
    "base_color_texture": { "file": "wood.png", "wrap_u": "clamp", "wrap_v": "mirror", "x": 2 },
    "metallic_roughness_texture": { "file": "wood.png" },
    "normal_texture": { "file": "wood.png" }, "emissive_texture": { "file": "wood.png" } })");
  const SceneDocument document = load_document(file, nullptr);
  const Material& material = document.scene.surfaces.at(0).material;
  EXPECT_EQ(material.type, Material::Type::metallic_roughness);
  const MetallicRoughness& values = material.metallic_roughness;
  EXPECT_EQ(values.base_color, glm::dvec3(1.0, 0.5, 0.25));
  EXPECT_EQ(values.metallic, 0.25);
  EXPECT_EQ(values.roughness, 0.75);
  EXPECT_EQ(values.emissive, glm::dvec3(0.0, 2.0, 30.0));
  EXPECT_EQ(values.normal_scale, 0.5);
  EXPECT_EQ(values.alpha, AlphaMode::cutout);
  EXPECT_EQ(values.opacity, 0.75);
  EXPECT_EQ(values.alpha_cutoff, 0.25);
  EXPECT_EQ(values.transmission, glm::dvec3(0.5, 0.25, 1.0));
  EXPECT_EQ(values.transmission_texture.content, values.base_color_texture.content);
  EXPECT_EQ(values.base_color_texture.file, wood_);
  EXPECT_EQ(values.base_color_texture.wrap_u, TextureWrap::clamp);
  EXPECT_EQ(values.base_color_texture.wrap_v, TextureWrap::mirror);
  EXPECT_EQ(values.base_color_texture.content->encoding(), Texture::Encoding::srgb);
  EXPECT_EQ(values.normal_texture.content->encoding(), Texture::Encoding::linear);
  EXPECT_EQ(values.base_color_texture.content, values.emissive_texture.content) << "is shared";
  EXPECT_EQ(files_of(document).size(), 5u);

  save_document(document, folder_ / "b.brume");
  const SceneDocument again = load_document(folder_ / "b.brume", nullptr);
  EXPECT_EQ(again.extras.unknown_keys, document.extras.unknown_keys);
  EXPECT_EQ(document_to_json(again, folder_.path()), content_of(folder_ / "b.brume"));
  const std::string text = content_of(folder_ / "b.brume");
  EXPECT_TRUE(
      contains(text, R"("wrap_u": "clamp")", R"("alpha": "cutout")", R"("later": 1)", R"("x": 2)"));
}

TEST_F(MaterialFile, HasTheDefaultsOfGltf) {
  const SceneDocument document = load_document(write(R"({ "type": "metallic_roughness" })"));
  EXPECT_EQ(document.scene.surfaces.at(0).material.metallic_roughness, MetallicRoughness{});
  EXPECT_FALSE(contains(document_to_json(document, folder_.path()), "texture"));
}

TEST_F(MaterialFile, MissingTextureIsAWarningThatNamesIt) {
  const fs::path file = write(R"({ "type": "metallic_roughness",
    "base_color_texture": { "file": "oak.png" }, "normal_texture": { "file": "bark.png" } })");
  std::vector<std::string> warnings;
  const SceneDocument document = load_document(file, &warnings);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_TRUE(contains(warnings[0], "surfaces[].material.base_color_texture.file", "oak.png"));
  EXPECT_TRUE(contains(warnings[1], "bark.png"));
  const MetallicRoughness& values = document.scene.surfaces.at(0).material.metallic_roughness;
  EXPECT_EQ(values.base_color_texture.content, nullptr);
  EXPECT_TRUE(contains(document_to_json(document, folder_.path()), "\"oak.png\"")) << "is kept";

  MissingFiles missing;
  load_document(file, nullptr, missing);
  EXPECT_EQ(missing.missing, (std::vector<fs::path>{folder_ / "oak.png", folder_ / "bark.png"}));
  missing = {.found = {{folder_ / "oak.png", wood_}}, .missing = {}};
  const SceneDocument found = load_document(file, nullptr, missing);
  EXPECT_NE(found.scene.surfaces.at(0).material.metallic_roughness.base_color_texture.content,
            nullptr);
}

TEST_F(MaterialFile, RefusesBadValues) {
  const std::string begin = R"({ "type": "metallic_roughness", )";
  EXPECT_TRUE(contains(error(begin + R"("base_color": [1, 2, 0] })"),
                       "surfaces[0].material.base_color[1]: found 2"));
  EXPECT_TRUE(contains(error(begin + R"("alpha": "mask" })"),
                       "surfaces[0].material.alpha: found \"mask\"; allowed: "));
  EXPECT_TRUE(
      contains(error(begin + R"("normal_texture": "wood.png" })"),
               "surfaces[0].material.normal_texture: found \"wood.png\"; allowed: an object"));
  EXPECT_TRUE(contains(error(begin + R"("normal_texture": {} })"),
                       "surfaces[0].material.normal_texture.file: missing"));
  EXPECT_TRUE(
      contains(error(begin + R"("normal_texture": { "file": "wood.png", "wrap_u": "x" } })"),
               "surfaces[0].material.normal_texture.wrap_u"));
  folder_.write("broken.png", "\x89PNG\r\n\x1a\n");
  const std::string broken = error(begin + R"("emissive_texture": { "file": "broken.png" } })");
  EXPECT_TRUE(contains(broken, "surfaces[0].material.emissive_texture.file", "broken.png"));
}

}  // namespace

}  // namespace brume
