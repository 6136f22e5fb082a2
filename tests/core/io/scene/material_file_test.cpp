#include <gtest/gtest.h>

#include "core/io/image/image_file.h"
#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "core/scene/materials/texture.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

class MaterialFile : public testing::Test {
 protected:
  fs::path write(const std::string& material) {
    return folder_.write("a.brume", R"({"format": "brume-scene", "version": 1, "surfaces": [
      {"primitive": {"type": "box"}, "material": )" +
                                        material + "}]}");
  }
  std::string error(const std::string& material) {
    return error_of([&] { load_document(write(material)); });
  }

  TemporaryFolder folder_;
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
  EXPECT_TRUE(contains(text, R"("wrap_u": "clamp")"));
  EXPECT_TRUE(contains(text, R"("alpha": "cutout")"));
  EXPECT_TRUE(contains(text, R"("later": 1)"));
  EXPECT_TRUE(contains(text, R"("x": 2)"));
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
  EXPECT_TRUE(contains(warnings[0], "surfaces[].material.base_color_texture.file"));
  EXPECT_TRUE(contains(warnings[0], "oak.png"));
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
  EXPECT_TRUE(contains(broken, "surfaces[0].material.emissive_texture.file"));
  EXPECT_TRUE(contains(broken, "broken.png"));
}

}  // namespace
}  // namespace brume
