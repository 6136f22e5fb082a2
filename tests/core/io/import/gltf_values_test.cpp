// Exporters write these beside the specification, and every other program reads them.

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "core/io/image/image_file.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

using Json = GltfBuilder::Json;

class GltfValues : public GltfTest {
 protected:
  std::shared_ptr<const ImportedScene> read() { return GltfTest::read(builder_); }
  MetallicRoughness read_material(const Json& material) {
    builder_.json["materials"] = {material};
    builder_.primitive()["material"] = 0;
    return read()->parts.at(0).material.metallic_roughness;
  }
  Light read_light(const Json& light) {
    builder_.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
    builder_.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    return read()->lights.at(0);
  }
  [[nodiscard]] bool is_warned(const std::string& text) const {
    return std::ranges::any_of(warnings_,
                               [&](const std::string& line) { return contains(line, text); });
  }
};

TEST_F(GltfValues, FactorsBeyondTheirRangeAreTheNearestAllowed) {
  const MetallicRoughness values = read_material(
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {1.0000001192092896, -1e-9, 0.5, 1.5}},
         {"metallicFactor", -0.01},
         {"roughnessFactor", 1.0000001192092896}}},
       {"emissiveFactor", {5, 0.5, -0.0}},
       {"alphaCutoff", 2.0},
       {"occlusionTexture", {{"index", 0}, {"strength", 3}}},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2.0}}}}}});
  EXPECT_EQ(values.base_color, glm::dvec3(1.0, 0.0, 0.5));
  EXPECT_EQ(values.metallic, 0.0);
  EXPECT_EQ(values.roughness, 1.0);
  EXPECT_EQ(values.emissive, glm::dvec3(2.0, 1.0, 0.0));
  EXPECT_TRUE(
      is_warned("materials[].pbrMetallicRoughness.roughnessFactor: found "
                "1.0000001192092896; allowed: a number in [0, 1]; taken as 1"));
  EXPECT_TRUE(is_warned("materials[].emissiveFactor[]: found 5"));
  EXPECT_EQ(warnings_.size(), 6u);
}

TEST_F(GltfValues, FactorsWithinTheirRangeAreNoWarning) {
  read_material(
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {1, 0, -0.0, 1}}, {"metallicFactor", 1}, {"roughnessFactor", 0}}},
       {"emissiveFactor", {1, 1, 1}}});
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(GltfValues, LightsBeyondTheirRangeAreTheNearestAllowed) {
  const Light light =
      read_light({{"type", "point"}, {"color", {1.0000001, 2, -1}}, {"intensity", 683}});
  EXPECT_EQ(light.intensity, glm::dvec3(1.0, 1.0, 0.0));
  EXPECT_EQ(warnings_.size(), 3u);
  const Light dark = read_light({{"type", "directional"}, {"intensity", -3}, {"range", -1}});
  EXPECT_EQ(dark.intensity, glm::dvec3(0.0));
  EXPECT_EQ(warnings_.size(), 1u);
}

TEST_F(GltfValues, SpotsMayHaveOneAngleAsBlenderWritesThem) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  const auto cone = [this](const Json& spot) {
    return std::get<light::Spot>(read_light({{"type", "spot"}, {"spot", spot}}).kind);
  };
  const light::Spot sharp = cone({{"innerConeAngle", 0.5}, {"outerConeAngle", 0.5}});
  EXPECT_EQ(sharp.inner_angle, sharp.outer_angle);
  EXPECT_NEAR(sharp.outer_angle, 0.5 * degrees, 1e-12);
  EXPECT_TRUE(warnings_.empty());
  const light::Spot swapped = cone({{"innerConeAngle", 1.0}, {"outerConeAngle", 0.5}});
  EXPECT_EQ(swapped, sharp);
  EXPECT_EQ(warnings_.size(), 1u);
  const light::Spot wide = cone({{"outerConeAngle", 2.0}});
  EXPECT_NEAR(wide.outer_angle, 90.0, 1e-3);
  EXPECT_GT(cone({{"outerConeAngle", 0.0}}).outer_angle, 0.0);
}

TEST_F(GltfValues, ImagesThatNothingUsesAreLeftAlone) {
  builder_.json["images"] = {{{"uri", "https://example.com/a.png"}},
                             {{"uri", "data:image/png;base64,*"}},
                             {{"bufferView", 77}},
                             {{"name", "neither"}}};
  builder_.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  EXPECT_EQ(read()->parts.size(), 1u);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(GltfValues, ImagesThatHaveNoFileAreMissing) {
  for (const Json& image : {Json{{"uri", "https://example.com/a.png"}},
                            Json{{"uri", "data:image/png;base64,*"}}, Json{{"name", "neither"}}}) {
    builder_.json["images"] = {image};
    builder_.json["textures"] = {{{"source", 0}}};
    const MetallicRoughness values =
        read_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    EXPECT_EQ(values.base_color_texture.content, nullptr);
    EXPECT_TRUE(is_warned("images[0].uri: found")) << image;
    EXPECT_EQ(warnings_.size(), 1u);
  }
}

TEST_F(GltfValues, MaterialsHaveHolesAndPanes) {
  const Json half = {{"baseColorFactor", {1, 1, 1, 0.5}}};
  const MetallicRoughness solid = read_material({{"pbrMetallicRoughness", half}});
  EXPECT_EQ(solid.alpha, AlphaMode::opaque);
  EXPECT_EQ(solid.opacity, 1.0);
  const MetallicRoughness leaf =
      read_material({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}, {"pbrMetallicRoughness", half}});
  EXPECT_EQ(leaf.alpha, AlphaMode::cutout);
  EXPECT_EQ(leaf.opacity, 0.5);
  EXPECT_EQ(leaf.alpha_cutoff, 0.25);
  const MetallicRoughness veil =
      read_material({{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", half}});
  EXPECT_EQ(veil.alpha, AlphaMode::blend);
  EXPECT_EQ(veil.opacity, 0.5);
  EXPECT_TRUE(warnings_.empty());
  read_material({{"alphaMode", "MASK"}, {"alphaCutoff", 2.0}});
  EXPECT_TRUE(is_warned("materials[].alphaCutoff: found 2"));
}

TEST_F(GltfValues, GlassTransmitsItsBaseColor) {
  const MetallicRoughness glass = read_material(
      {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0.5, 0, 1}}, {"metallicFactor", 0}}},
       {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}}}}}});
  EXPECT_EQ(glass.transmission, glm::dvec3(0.5, 0.25, 0.0));
  EXPECT_EQ(glass.alpha, AlphaMode::opaque);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(GltfValues, CompressedMeshesWithoutOtherDataAreToldToBeMissing) {
  builder_.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  builder_.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  EXPECT_EQ(read()->parts.size(), 1u);  // the same data besides
  EXPECT_FALSE(is_warned("missing"));
  for (Json& accessor : builder_.json["accessors"]) accessor.erase("bufferView");
  builder_.json["accessors"][0]["count"] = 1 << 24;
  EXPECT_TRUE(read()->parts.empty());
  EXPECT_TRUE(is_warned(
      "meshes[].primitives[].attributes: a mesh of the node square is missing: it has only "
      "data compressed by KHR_draco_mesh_compression; export it again without Draco "
      "compression"));
}

TEST_F(GltfValues, CompressedBuffersWithoutOtherDataAreToldToBeMissing) {
  builder_.json["extensionsUsed"] = {"EXT_meshopt_compression"};
  for (Json& view : builder_.json["bufferViews"]) {
    view["buffer"] = 1;
    view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
  }
  Json root = builder_.json;
  root["buffers"] = {{{"byteLength", 3}, {"uri", "data:;base64,AAAA"}},
                     {{"byteLength", builder_.buffer().size()},
                      {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  const auto scene = read_imported_scene(folder_.write("scene.gltf", root.dump()), warnings_);
  EXPECT_TRUE(scene->parts.empty());
  EXPECT_TRUE(
      is_warned("a mesh of the node square is missing: it has only data compressed by "
                "EXT_meshopt_compression; export it again without compression"));
}

// Colors of vertices and texture coordinates of glTF.

class GltfMeshValues : public GltfTest {
 protected:
  std::vector<glm::vec4> colors_of(const GltfBuilder& builder) { return mesh_of(builder).colors; }
  // The only warning of a mesh whose `attribute` is left out.
  std::string left_out(const char* attribute, std::size_t accessor) {
    GltfBuilder builder = builder_;
    builder.primitive()["attributes"][attribute] = accessor;
    const MeshArrays mesh = mesh_of(builder);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(mesh.colors.empty());
    if (warnings_.size() != 1) return "found " + std::to_string(warnings_.size()) + " warnings";
    const std::string place =
        (folder_ / "scene.glb").string() + ": meshes[0].primitives[0].attributes." + attribute;
    EXPECT_TRUE(warnings_[0].starts_with(place + ": ")) << warnings_[0];
    EXPECT_TRUE(warnings_[0].ends_with("; it is left out")) << warnings_[0];
    return warnings_[0];
  }
  // Textures by three sets of texture coordinates.
  void add_textures() {
    const std::array<std::uint8_t, 12> pixels{};
    const std::string png = encode_png(2, 2, pixels);
    builder_.json["images"] = {
        {{"bufferView", builder_.add_view(png.data(), png.size())}, {"mimeType", "image/png"}}};
    builder_.json["textures"] = {{{"source", 0}}};
    builder_.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}},
         {"normalTexture", {{"index", 0}}}}};
    builder_.primitive()["material"] = 0;
    builder_.primitive()["attributes"]["TEXCOORD_1"] =
        builder_.add({0.5f, 0, 0.5f, 0, 0.5f, 0, 0.25f, 1}, "VEC2");
  }
};

TEST_F(GltfMeshValues, HasColorsOfAllTypes) {
  GltfBuilder::Json& attributes = builder_.primitive()["attributes"];
  attributes["COLOR_0"] = builder_.add({1, 0, 0, 0, 0.5f, 0, 0, 0, 1, 1, 1, 1}, "VEC3");
  const std::vector<glm::vec4> wanted{{1, 0, 0, 1}, {0, 0.5f, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
  EXPECT_EQ(colors_of(builder_), wanted) << "linear as they are";
  EXPECT_TRUE(warnings_.empty());
  attributes["COLOR_0"] = builder_.add_integers<std::uint8_t>(
      {255, 0, 0, 51, 0, 0, 0, 255, 0, 0, 0, 0, 255, 255, 255, 255}, "VEC4");
  builder_.json["accessors"].back()["normalized"] = true;
  const std::vector<glm::vec4> bytes = colors_of(builder_);
  EXPECT_EQ(bytes.at(0), glm::vec4(1, 0, 0, 0.2f));
  EXPECT_EQ(bytes.at(3), glm::vec4(1.0f));
  attributes["COLOR_0"] = builder_.add_integers<std::uint16_t>(
      {65535, 0, 13107, 0, 0, 0, 0, 0, 0, 65535, 65535, 65535}, "VEC3");
  builder_.json["accessors"].back()["normalized"] = true;
  EXPECT_EQ(colors_of(builder_).at(0), glm::vec4(1, 0, 0.2f, 1));
}

TEST_F(GltfMeshValues, FlatTrianglesKeepColors) {
  GltfBuilder::Json& attributes = builder_.primitive()["attributes"];
  attributes.erase("NORMAL");
  attributes["COLOR_0"] = builder_.add({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, "VEC3");
  const std::vector<glm::vec4> colors = colors_of(builder_);
  ASSERT_EQ(colors.size(), 6u);
  EXPECT_EQ(colors[4], glm::vec4(0, 0, 1, 1)) << "the corner 2 of the triangle 0 2 3";
}

TEST_F(GltfMeshValues, ColorsBeyondAreTakenAsTheNearest) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  builder_.primitive()["attributes"]["COLOR_0"] =
      builder_.add({1.5f, -1, nan, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  EXPECT_EQ(colors_of(builder_).at(0), glm::vec4(1, 0, 0, 1));
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "COLOR_0: found colors outside [0, 1]")) << warnings_[0];
}

TEST_F(GltfMeshValues, WrongColorsAreLeftOut) {
  const auto warning = [&](std::size_t accessor) { return left_out("COLOR_0", accessor); };
  const std::string what = "; allowed: one with 3 or 4 components, floats or normalized";
  EXPECT_TRUE(contains(warning(builder_.add({1, 0, 1, 0, 1, 0, 1, 0}, "VEC2")), what));
  EXPECT_TRUE(contains(
      warning(builder_.add_integers<std::uint8_t>(std::vector<std::uint8_t>(12), "VEC3")), what))
      << "integers that are not normalized";
  EXPECT_TRUE(contains(warning(builder_.add({1, 0, 1, 0, 1, 0}, "VEC3")),
                       "found 2 values; allowed: 4, one for each vertex"));
  EXPECT_TRUE(contains(warning(99), "COLOR_0: found 99"));
  const std::size_t beyond = builder_.add({1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0}, "VEC3");
  builder_.json["accessors"][beyond]["count"] = 4000;
  EXPECT_TRUE(contains(warning(beyond), "].count: needs 48000 bytes of a buffer view of 48"));
}

TEST_F(GltfMeshValues, OtherAttributesThatAreWrongAreLeftOut) {
  const std::string count = "found 2 values; allowed: 4, one for each vertex";
  const std::size_t vectors = builder_.add({0, 0, 1, 0, 0, 1}, "VEC3");
  EXPECT_TRUE(contains(left_out("NORMAL", vectors), count));
  EXPECT_TRUE(contains(left_out("TEXCOORD_0", vectors), "3 components; allowed: 2"));
  const std::size_t beyond = builder_.add({0, 0, 1, 0}, "VEC2");
  EXPECT_TRUE(contains(left_out("TEXCOORD_0", beyond), count));
  add_textures();
  EXPECT_TRUE(contains(left_out("TEXCOORD_1", beyond), count)) << "which a texture uses";
}

TEST_F(GltfMeshValues, ManyWrongAttributesAreOneWarning) {
  builder_.primitive()["attributes"]["COLOR_0"] = builder_.add({1, 0, 1, 0, 1, 0}, "VEC3");
  GltfBuilder::Json other = builder_.primitive();
  other["attributes"]["COLOR_0"] = builder_.add({1, 0, 1}, "VEC3");
  builder_.json["meshes"][0]["primitives"].push_back(other);
  read(builder_)->parts.at(0);
  EXPECT_EQ(warnings_.size(), 1u);
}

TEST_F(GltfMeshValues, AMorphTargetThatIsWrongIsLeftOut) {
  builder_.json["meshes"][0]["weights"] = {1};
  builder_.primitive()["targets"] = {{{"POSITION", builder_.add({0, 0, 1}, "VEC3")}}};
  EXPECT_EQ(to_arrays(*read(builder_)->parts.at(0).mesh).points.at(2), glm::vec3(1, 1, 0));
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "meshes[0].primitives[0].targets[0].POSITION: found 1 values"))
      << warnings_[0];
}

TEST_F(GltfMeshValues, HasTwoSetsOfTexcoords) {
  add_textures();
  const ImportedPart part = read(builder_)->parts.at(0);
  EXPECT_TRUE(warnings_.empty());
  const MeshArrays& mesh = to_arrays(*part.mesh);
  // The first set is that of the material's first texture.
  EXPECT_EQ(mesh.texcoords.at(3), glm::vec2(0.25f, 0.0f));
  EXPECT_EQ(mesh.second_texcoords.at(1), glm::vec2(1.0f, 0.0f));
  const MetallicRoughness& material = part.material.metallic_roughness;
  EXPECT_FALSE(material.base_color_texture.uses_second_texcoords);
  EXPECT_TRUE(material.normal_texture.uses_second_texcoords);
}

TEST_F(GltfMeshValues, TransformsOfTexturesMakeSets) {
  add_textures();
  GltfBuilder::Json& normal = builder_.json["materials"][0]["normalTexture"];
  normal["texCoord"] = 1;
  normal["extensions"]["KHR_texture_transform"]["scale"] = {2.0, 2.0};
  const MeshArrays mesh = to_arrays(*read(builder_)->parts.at(0).mesh);
  EXPECT_TRUE(warnings_.empty());
  EXPECT_EQ(mesh.texcoords.at(3), glm::vec2(0.25f, 0.0f));
  EXPECT_EQ(mesh.second_texcoords.at(3), glm::vec2(0.5f, -1.0f));
}

TEST_F(GltfMeshValues, AThirdSetIsThatOfTheFirstTexture) {
  add_textures();
  builder_.json["materials"][0]["emissiveTexture"] = {{"index", 0}, {"texCoord", 2}};
  builder_.json["materials"][0]["emissiveFactor"] = {1, 1, 1};
  const ImportedPart part = read(builder_)->parts.at(0);
  EXPECT_FALSE(part.material.metallic_roughness.emissive_texture.uses_second_texcoords);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "emissiveTexture: has texture coordinates of its own"));
}

TEST_F(GltfMeshValues, AMissingSetIsAWarning) {
  add_textures();
  builder_.primitive()["attributes"].erase("TEXCOORD_1");
  const MeshArrays mesh = to_arrays(*read(builder_)->parts.at(0).mesh);
  EXPECT_EQ(mesh.texcoords, std::vector<glm::vec2>(4, {0, 1}));
  EXPECT_EQ(mesh.second_texcoords.at(1), glm::vec2(1.0f, 0.0f));
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "TEXCOORD_1: missing: a texture uses it")) << warnings_[0];
}

}  // namespace

}  // namespace brume
