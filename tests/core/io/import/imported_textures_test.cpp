// Textures of other programs' scenes: what is not found or cannot be read counts as white.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/io/image/image_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/scene/materials/texture.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

// A TGA of one red pixel.
std::string red_tga() {
  std::string bytes(18, '\0');
  bytes[2] = 2;
  bytes[12] = bytes[14] = 1;
  bytes[16] = 24;
  return bytes + std::string("\0\0\xff", 3);
}

std::string red_png() {
  return encode_png(1, 1, std::vector<std::uint8_t>{255, 0, 0});
}

class ImportedTextures : public FolderTest {
 protected:
  // The base color of the first part.
  const Texture* read(const fs::path& file) {
    warnings_.clear();
    scene_ = read_imported_scene(file, warnings_);
    return scene_->parts.at(0).material.metallic_roughness.base_color_texture.content.get();
  }

  // An OBJ that uses a material of `mtl`, which is written as a.mtl.
  fs::path write_obj(const std::string& mtl, const std::string& library = "a.mtl") {
    folder_.write("a.mtl", "newmtl m\nKd 1 1 1\n" + mtl);
    return folder_.write("a.obj", "mtllib " + library +
                                      "\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                      "usemtl m\nf 1/1 2/2 3/3\n");
  }

  // A scene whose first image is the base color.
  fs::path write_gltf(GltfBuilder builder, const GltfBuilder::Json& image) {
    builder.json["images"] = {image};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    builder.primitive()["material"] = 0;
    return folder_.write("a.glb", builder.binary());
  }

  void expect_warning(const std::string& part, const std::string& other = "") {
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_TRUE(contains(warnings_[0], part, other));
  }

  std::vector<std::string> warnings_;
  std::shared_ptr<const ImportedScene> scene_;
};

TEST_F(ImportedTextures, TgaIsRead) {
  folder_.write("red.tga", red_tga());
  const Texture* texture = read(write_obj("map_Kd red.tga\n"));
  EXPECT_TRUE(warnings_.empty()) << warnings_[0];
  ASSERT_NE(texture, nullptr);
  EXPECT_EQ(texture->average(), glm::vec4(1, 0, 0, 1));
}

TEST_F(ImportedTextures, UnreadableOnesCountAsWhite) {
  const std::string truncated = red_png().substr(0, 40);
  const std::pair<const char*, std::string> files[] = {
      {"a.webp", std::string("RIFF\0\0\0\0WEBP", 12)},
      {"a.tif", std::string("II*\0", 4)},
      {"lfs.png", "version https://git-lfs.github.com/spec/v1\n"},
      {"truncated.png", truncated},
      {"empty.png", ""}};
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    const fs::path file = folder_.write(name, content);
    EXPECT_EQ(read(write_obj(std::string("map_Kd ") + name + "\n")), nullptr);
    expect_warning("a.obj: the texture " + file.string() + ": ", "; it counts as white");
    EXPECT_EQ(scene_->files.back(), file) << "read again when it has changed";
  }
  fs::create_directory(folder_ / "folder.png");
  EXPECT_EQ(read(write_obj("map_Kd folder.png\n")), nullptr);
  expect_warning("is a folder");
}

// An emission that its texture would show in a few places is not that of the whole surface.
TEST_F(ImportedTextures, NothingIsEmittedWhereThatOfEmissionIsMissing) {
  folder_.write("bad.png", "no picture");
  for (const char* name : {"gone.png", "bad.png", "red.png"}) {
    SCOPED_TRACE(name);
    GltfBuilder builder;
    builder.json["images"] = {{{"uri", name}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {
        {{"emissiveFactor", {1, 1, 0.5}}, {"emissiveTexture", {{"index", 0}}}}};
    builder.primitive()["material"] = 0;
    folder_.write("red.png", red_png());
    read(folder_.write("a.glb", builder.binary()));
    const bool is_there = name == std::string("red.png");
    EXPECT_EQ(scene_->parts[0].material.metallic_roughness.emissive,
              is_there ? glm::dvec3(1.0, 1.0, 0.5) : glm::dvec3(0.0));
    if (!is_there) expect_warning(name);
  }
}

// Its header alone says how large it would be.
TEST_F(ImportedTextures, TooLargeOnesCountAsWhite) {
  folder_.write("t.png",
                std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x80\0\0\0\x80\0\x08\x02\0\0\0"
                            "\x4b\x1e\x34\x28",
                            33));
  EXPECT_EQ(read(write_gltf({}, {{"uri", "t.png"}})), nullptr);
  expect_warning("t.png", "16384");
}

TEST_F(ImportedTextures, EmbeddedOnesAreNamed) {
  GltfBuilder builder;
  const std::string damaged = "no picture";
  const std::size_t view = builder.add_view(damaged.data(), damaged.size());
  EXPECT_EQ(read(write_gltf(builder, {{"bufferView", view}, {"name", "wood"}})), nullptr);
  expect_warning("a.glb: the texture images[0] (wood): header: found no image");
  EXPECT_EQ(read(write_gltf({}, {{"uri", "data:image/png;base64,AAAA"}})), nullptr);
  expect_warning("a.glb: the texture images[0]: header: found no image");
  EXPECT_EQ(read(write_gltf({}, {{"uri", "data:image/png;base64,*"}})), nullptr);
  expect_warning("a.glb: the texture images[0].uri: found data:image/png", "allowed: base64 data");
  EXPECT_EQ(read(write_gltf({}, {{"uri", "http://x/y.png"}})), nullptr);
  expect_warning("a.glb: the texture images[0].uri: found http://x/y.png");
  EXPECT_EQ(read(write_gltf({}, {{"bufferView", 99}})), nullptr);
  expect_warning("a.glb: the texture images[0].bufferView: found 99");
}

TEST_F(ImportedTextures, ThoseThatNoMaterialUsesAreNotRead) {
  GltfBuilder builder;
  builder.json["images"] = {{{"uri", "http://x/y.png"}}};
  read(folder_.write("a.glb", builder.binary()));
  EXPECT_TRUE(warnings_.empty()) << warnings_[0];
}

// One warning for an image that is used as colors and as other values.
TEST_F(ImportedTextures, OneOfTwoUsesIsTold) {
  GltfBuilder builder;
  builder.json["images"] = {{{"uri", "t.png"}}};
  builder.json["textures"] = {{{"source", 0}}};
  builder.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                {"normalTexture", {{"index", 0}}}}};
  builder.primitive()["material"] = 0;
  folder_.write("t.png", "no picture");
  EXPECT_EQ(read(folder_.write("a.glb", builder.binary())), nullptr);
  expect_warning("t.png: header: found no image of a known kind");
}

TEST_F(ImportedTextures, AreFoundAsWindowsNamesThem) {
  folder_.write("Textures/red.png", red_png());
  folder_.write("blue.png", red_png());
  for (const char* line :
       {"map_Kd textures\\RED.png\n", "map_Kd Textures/red.png \t\n", "map_Kd BLUE.PNG\r\n",
        "map_Kd C:\\work\\Blue.png\n", "map_Kd .\\textures\\Red.PNG\n"}) {
    EXPECT_NE(read(write_obj(line)), nullptr) << line;
    EXPECT_TRUE(warnings_.empty()) << line << warnings_[0];
  }
  EXPECT_NE(read(write_gltf({}, {{"uri", "textures%2FRed.PNG"}})), nullptr);
  EXPECT_NE(read(write_gltf({}, {{"uri", "Textures\\red.png"}})), nullptr);
  folder_.write("100%25.png", red_png());
  EXPECT_NE(read(write_gltf({}, {{"uri", "100%25.png"}})), nullptr) << "not encoded at all";
  folder_.write("100%.png", red_png());
  EXPECT_NE(read(write_gltf({}, {{"uri", "100%25.png"}})), nullptr);
  EXPECT_EQ(scene_->files.back(), folder_ / "100%.png") << "encoded, as it should be";
}

TEST_F(ImportedTextures, MaterialFilesAreFoundAsWindowsNamesThem) {
  folder_.write("red.png", red_png());
  for (const char* library : {"A.MTL", "a.mtl ", ".\\A.mtl", "C:\\work\\a.mtl"}) {
    EXPECT_NE(read(write_obj("map_Kd red.png\n", library)), nullptr) << library;
    EXPECT_TRUE(warnings_.empty()) << library << warnings_[0];
  }
}

TEST_F(ImportedTextures, OneLineMayNameSeveralMaterialFiles) {
  folder_.write("red.png", red_png());
  folder_.write("other.mtl", "newmtl other\nKd 0.5 0.5 0.5");
  const auto has_texture = [&](const char* names) {
    return read(write_obj("map_Kd red.png\n", names));
  };
  for (const char* names : {"other.mtl a.mtl", "a.mtl\tother.mtl ", "other.mtl A.MTL a.mtl"}) {
    EXPECT_NE(has_texture(names), nullptr) << names;
    EXPECT_TRUE(warnings_.empty()) << names << warnings_[0];
    EXPECT_EQ(std::ranges::count(scene_->files, folder_ / "other.mtl"), 1) << names;
  }
  EXPECT_NE(has_texture("gone.mtl a.mtl"), nullptr);
  expect_warning("the material file " + (folder_ / "gone.mtl").string() + " is missing");
  // A name with blanks is one file where there is such a file.
  folder_.write("my a.mtl", content_of(folder_ / "a.mtl"));
  folder_.write("a.mtl", "newmtl m\nKd 1 1 1\n");
  const fs::path file = folder_.write("a.obj",
                                      "mtllib my a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\n"
                                      "usemtl m\nf 1/1 2/1 3/1\n");
  EXPECT_NE(read(file), nullptr);
}

TEST_F(ImportedTextures, TextMayBeginWithAByteOrderMark) {
  folder_.write("red.png", red_png());
  const std::string mark = "\xef\xbb\xbf";
  const fs::path file = write_obj("map_Kd red.png\n");
  folder_.write("a.mtl", mark + content_of(folder_ / "a.mtl"));
  folder_.write("a.obj", mark + content_of(file));
  EXPECT_NE(read(file), nullptr);
  EXPECT_TRUE(obj_has_materials(file));
}

TEST_F(ImportedTextures, MissingMaterialFilesAreTold) {
  const fs::path file = write_obj("", "a.mtl");
  fs::remove(folder_ / "a.mtl");
  read(file);
  expect_warning("a.obj: the material file " + (folder_ / "a.mtl").string() + " is missing");
  const fs::path other = write_obj("", "other.mtl");
  fs::remove(folder_ / "a.mtl");
  read(other);
  expect_warning("a.obj: the material file " + (folder_ / "other.mtl").string() + " is missing");
}

// The mask of an MTL file becomes the alpha of the base color.
TEST_F(ImportedTextures, MasksAreAlpha) {
  folder_.write("mask.png", encode_png(2, 1, std::vector<std::uint8_t>{255, 255, 255, 0, 0, 0}));
  folder_.write("red.png", red_png());
  for (const std::string color : {"map_Kd red.png\n", ""}) {
    const Texture* texture = read(write_obj(color + "map_d mask.png\n"));
    EXPECT_TRUE(warnings_.empty());
    ASSERT_NE(texture, nullptr);
    EXPECT_EQ(texture->width(), 2);
    const glm::vec4 left = texture->texel(texture->levels()[0], 0, 0);
    EXPECT_EQ(left, color.empty() ? glm::vec4(1.0f) : glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(texture->texel(texture->levels()[0], 1, 0).a, 0.0f);
    const MetallicRoughness& values = scene_->parts.at(0).material.metallic_roughness;
    EXPECT_EQ(values.alpha, AlphaMode::blend);
    EXPECT_EQ(values.opacity, 1.0);
  }
}

// Only the red of a texture of transmission counts; the base color's tints it.
TEST_F(ImportedTextures, GlassIsTinted) {
  folder_.write("share.png", encode_png(1, 1, std::vector<std::uint8_t>{255, 0, 128}));
  folder_.write("red.png", red_png());
  GltfBuilder builder;
  builder.json["images"] = {{{"uri", "red.png"}}, {{"uri", "share.png"}}};
  builder.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  GltfBuilder::Json extension = {{"transmissionFactor", 1.0}};
  const auto crossing = [&] {
    builder.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}},
         {"extensions", {{"KHR_materials_transmission", extension}}}}};
    builder.primitive()["material"] = 0;
    read(folder_.write("a.glb", builder.binary()));
    const auto& texture =
        scene_->parts.at(0).material.metallic_roughness.transmission_texture.content;
    return texture ? glm::vec3(texture->average()) : glm::vec3(-1.0f);
  };
  EXPECT_EQ(crossing(), glm::vec3(1, 0, 0));
  extension["transmissionTexture"] = {{"index", 1}};
  EXPECT_EQ(crossing(), glm::vec3(1, 0, 0));
  EXPECT_TRUE(warnings_.empty());
}

}  // namespace
}  // namespace brume
