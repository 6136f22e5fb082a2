// Exporters write these beside the specification, and every other program reads them.

#include <gtest/gtest.h>

#include <numbers>

#include "core/io/import/imported_scene_file.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

using Json = GltfBuilder::Json;

class GltfValues : public ::testing::Test {
 protected:
  std::shared_ptr<const ImportedScene> read() {
    warnings_.clear();
    return read_imported_scene(folder_.write("scene.glb", builder_.binary()), warnings_);
  }
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

  GltfBuilder builder_;
  TemporaryFolder folder_;
  std::vector<std::string> warnings_;
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

}  // namespace
}  // namespace brume
