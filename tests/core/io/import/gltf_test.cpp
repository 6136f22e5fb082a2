#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/io/image/image_file.h"
#include "core/io/import/scene_readers.h"
#include "core/scene/materials/texture.h"
#include "core/scene/mesh.h"
#include "core/scene/placement.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

using Gltf = GltfTest;

// An image of one color as PNG.
std::string png(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  const std::array<std::uint8_t, 12> pixels{red, green, blue, red, green, blue,
                                            red, green, blue, red, green, blue};
  return encode_png(2, 2, pixels);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-6) << a.x << " " << a.y << " " << a.z;
}

TEST_F(Gltf, HasMeshesWithTextureCoordinatesUpwards) {
  const MeshArrays mesh = mesh_of(GltfBuilder());
  EXPECT_EQ(mesh.points, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(4, {0, 0, 1}));
  EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.texcoords, (std::vector<glm::vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(Gltf, IsTheSameAsTextWithABuffer) {
  const GltfBuilder builder;
  folder_.write("a b.bin", builder.buffer());
  const auto scene =
      read_imported_scene(folder_.write("scene.gltf", builder.text("a%20b.bin")), warnings_);
  EXPECT_EQ(to_arrays(*scene->parts.at(0).mesh), mesh_of(builder));
  EXPECT_EQ(scene->files, (std::vector{folder_ / "scene.gltf", folder_ / "a b.bin"}));
}

TEST_F(Gltf, MaterialsHaveTheirNames) {
  GltfBuilder builder;
  EXPECT_EQ(read(builder)->parts.at(0).material.name, "material 0");
  builder.json["materials"] = {{{"name", "Brushed\nbrass"}}};
  builder.primitive()["material"] = 0;
  EXPECT_EQ(read(builder)->parts.at(0).material.name, "Brushedbrass");
}

TEST_F(Gltf, MaterialsOfOneNameAreToldApart) {
  GltfBuilder builder;
  builder.json["materials"] = {{{"name", "wood"}}, {{"name", "wood"}}};
  builder.primitive()["material"] = 0;
  auto second = builder.primitive();
  second["material"] = 1;
  builder.json["meshes"][0]["primitives"].push_back(second);
  const auto scene = read(builder);
  ASSERT_EQ(scene->parts.size(), 2u);
  EXPECT_EQ(scene->parts[0].material.name, "wood");
  EXPECT_EQ(scene->parts[1].material.name, "wood 2");
}

TEST_F(Gltf, TransformsOfNodesAreInTheMesh) {
  GltfBuilder builder;
  const double s = std::sqrt(0.5);  // a quarter turn about y: x to -z, z to x
  builder.json["nodes"] = {
      {{"name", "top"}, {"children", {1}}, {"translation", {10, 0, 0}}},
      {{"name", "turned"}, {"children", {2}}, {"rotation", {0, s, 0, s}}, {"scale", {2, 1, 1}}},
      {{"name", "moved"}, {"mesh", 0}, {"translation", {0, 0, 3}}}};
  const auto scene = read(builder);
  ASSERT_EQ(scene->nodes.size(), 3u);
  EXPECT_EQ(scene->nodes[2].parent, 1u);
  EXPECT_EQ(scene->parts.at(0).node, 2u);
  const MeshArrays mesh = to_arrays(*scene->parts[0].mesh);
  expect_near(mesh.points[0], {13, 0, 0});
  expect_near(mesh.points[1], {13, 0, -2});
  expect_near(mesh.normals[0], {1, 0, 0});
}

TEST_F(Gltf, NodesThatShareAMeshShareItsMemory) {
  GltfBuilder builder;
  constexpr std::size_t count = 20;
  builder.json["scenes"][0]["nodes"].clear();
  builder.json["nodes"].clear();
  for (std::size_t i = 0; i < count; ++i) {
    builder.json["scenes"][0]["nodes"].push_back(i);
    builder.json["nodes"].push_back(
        {{"mesh", 0}, {"translation", {i, 0, 0}}, {"scale", {2, 2, 2}}});
  }
  Surface whole;
  whole.imported = read(builder);
  whole.translate = {0, 1, 0};
  ASSERT_EQ(whole.imported->parts.size(), count);
  EXPECT_EQ(whole.imported->parts[0].mesh, whole.imported->parts[7].mesh);
  const std::vector<Surface> shown = shown_surfaces(std::span(&whole, 1), 0.0);
  ASSERT_EQ(shown.size(), 1u);
  ASSERT_EQ(placement_count(shown[0]), count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 place = placement_of(shown[0], i).point_to_world({1, 0, 0});
    EXPECT_EQ(place, glm::dvec3(static_cast<double>(i) + 2.0, 1, 0));
  }
  EXPECT_EQ(shown_surfaces(std::span(&whole, 1), 0.0)[0].placed_copies, shown[0].placed_copies);
  // A few are told apart; one that is stretched is a mesh of its own.
  builder.json["scenes"][0]["nodes"] = {0, 1, 2};
  builder.json["nodes"][2]["scale"] = {1, 2, 1};
  whole.imported = read(builder);
  EXPECT_EQ(shown_surfaces(std::span(&whole, 1), 0.0).size(), 3u);
  EXPECT_EQ(whole.imported->parts[0].mesh, whole.imported->parts[1].mesh);
  EXPECT_NE(whole.imported->parts[0].mesh, whole.imported->parts[2].mesh);
  expect_near(to_arrays(*whole.imported->parts[2].mesh).points[2], {3, 2, 0});
}

TEST_F(Gltf, InstancesAreCopies) {
  GltfBuilder builder;
  const float s = std::sqrt(0.5f);  // a quarter turn about z: x to y
  const std::size_t translations = builder.add({1, 0, 0, 5, 0, 0}, "VEC3");
  const std::size_t rotations = builder.add({0, 0, 0, 1, 0, 0, s, s}, "VEC4");
  const std::size_t scales = builder.add({1, 1, 1, 3, 3, 3}, "VEC3");
  builder.json["nodes"][0]["translation"] = {0, 0, 7};
  GltfBuilder::Json& attributes =
      builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes = {{"TRANSLATION", translations}, {"ROTATION", rotations}, {"SCALE", scales}};
  builder.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  Surface whole;
  whole.imported = read(builder);
  const std::vector<Surface> shown = shown_surfaces(std::span(&whole, 1), 0.0);
  ASSERT_EQ(shown.size(), 1u);
  ASSERT_EQ(placement_count(shown[0]), 2u);
  expect_near(placement_of(shown[0], 0).point_to_world({1, 0, 0}), {2, 0, 7});
  expect_near(placement_of(shown[0], 1).point_to_world({1, 0, 0}), {5, 3, 7});
  EXPECT_EQ(to_arrays(*joined_mesh(chosen_parts(*whole.imported, {}))).triangles.size(), 4u);
  attributes["SCALE"] = builder.add({1, 1, 1}, "VEC3");
  EXPECT_THROW(read(builder), InputError);
}

// Light and shadow need outward normals and the winding that goes with them.
TEST_F(Gltf, MirroredAndShearedMeshesFaceTheSameSide) {
  const auto check = [this](const GltfBuilder& builder) {
    const MeshArrays mesh = mesh_of(builder);
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::vec3 side = glm::normalize(
          glm::cross(mesh.points[t.y] - mesh.points[t.x], mesh.points[t.z] - mesh.points[t.x]));
      expect_near(mesh.normals[t.x], side);
    }
    return mesh.normals[0];
  };
  GltfBuilder mirrored;
  mirrored.json["nodes"][0]["scale"] = {-1, 2, 1};
  expect_near(check(mirrored), {0, 0, 1});
  GltfBuilder inverted;  // a mirror in its own plane turns it around
  inverted.json["nodes"][0]["scale"] = {1, 1, -1};
  expect_near(check(inverted), {0, 0, -1});
  GltfBuilder sheared;  // z grows with x
  sheared.json["nodes"][0]["matrix"] = {1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  expect_near(check(sheared), {-std::sqrt(0.5), 0, std::sqrt(0.5)});
}

TEST_F(Gltf, WarnsOfExtensionsThatItLeavesOut) {
  GltfBuilder builder;
  builder.json["extensionsUsed"] = {"KHR_mesh_quantization", "KHR_materials_sheen", "X_y"};
  builder.json["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_materials_sheen"};
  read(builder);
  ASSERT_EQ(warnings_.size(), 2u);
  EXPECT_TRUE(contains(warnings_[0], "KHR_materials_sheen"));
  EXPECT_TRUE(contains(warnings_[1], "X_y"));
}

TEST_F(Gltf, WhatMakesMaterialsLookDifferentIsNotNeeded) {
  GltfBuilder builder;
  builder.json["extensionsRequired"] = {"KHR_materials_diffuse_transmission", "KHR_xmp_json_ld",
                                        "EXT_texture_webp", "KHR_animation_pointer"};
  // A texture of another format counts as white, and one of emission as black.
  builder.json["images"] = {{{"uri", "a.webp"}}};
  builder.json["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
  builder.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                {"emissiveTexture", {{"index", 0}}},
                                {"emissiveFactor", {1, 1, 1}}}};
  builder.primitive()["material"] = 0;
  folder_.write("a.webp", "RIFF....WEBPVP8 ");
  const MetallicRoughness material = read(builder)->parts.at(0).material.metallic_roughness;
  EXPECT_EQ(material.emissive, glm::dvec3(0.0));
  EXPECT_EQ(material.base_color_texture.content, nullptr);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "a.webp")) << warnings_[0];
  builder.json["extensionsRequired"] = {"KHR_node_of_the_future"};
  EXPECT_THROW(read(builder), InputError);
}

TEST_F(Gltf, GlossyMaterialsAreDielectrics) {
  GltfBuilder builder;
  builder.json["materials"] = {
      {{"extensions",
        {{"KHR_materials_pbrSpecularGlossiness",
          {{"diffuseFactor", {0.5, 0.25, 0.125, 1}}, {"glossinessFactor", 0.75}}}}},
       {"pbrMetallicRoughness", {{"roughnessFactor", 0.1}}}}};
  builder.primitive()["material"] = 0;
  const MetallicRoughness material = read(builder)->parts.at(0).material.metallic_roughness;
  EXPECT_EQ(material.base_color, glm::dvec3(0.5, 0.25, 0.125));
  EXPECT_EQ(material.roughness, 0.25);
  EXPECT_EQ(material.metallic, 0.0);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "pbrSpecularGlossiness: specular colors")) << warnings_[0];
}

TEST_F(Gltf, MeshesWithoutNormalsAreFlat) {
  GltfBuilder builder;
  builder.primitive()["attributes"].erase("NORMAL");
  const MeshArrays mesh = mesh_of(builder);
  EXPECT_EQ(mesh.points.size(), 6u);
  EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(6, {0, 0, 1}));
}

TEST_F(Gltf, ReadsStripsFansAndTrianglesWithoutIndices) {
  GltfBuilder builder;
  builder.primitive().erase("indices");
  builder.primitive()["mode"] = 6;
  EXPECT_EQ(mesh_of(builder).triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
  builder.primitive()["mode"] = 5;
  EXPECT_EQ(mesh_of(builder).triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 3}}));
  builder.primitive()["mode"] = 4;
  EXPECT_EQ(mesh_of(builder).triangles, (std::vector<glm::uvec3>{{0, 1, 2}}));
  builder.primitive()["mode"] = 0;
  EXPECT_TRUE(read(builder)->parts.empty());
  EXPECT_TRUE(contains(warnings_.at(0), "points and lines are left out"));
}

TEST_F(Gltf, ReadsIntegersStridesAndSparseAccessors) {
  GltfBuilder builder;
  const std::size_t texcoords =
      builder.add_integers<std::uint16_t>({0, 65535, 65535, 65535, 65535, 0, 0, 0}, "VEC2");
  builder.json["accessors"][texcoords]["normalized"] = true;
  builder.primitive()["attributes"]["TEXCOORD_0"] = texcoords;
  EXPECT_EQ(mesh_of(builder), mesh_of(GltfBuilder()));

  const std::vector<float> padded{0, 0, 0, 9, 1, 0, 0, 9, 1, 1, 0, 9, 0, 1, 0, 9};
  builder.json["accessors"][0]["bufferView"] = builder.add_view(padded.data(), 64);
  builder.json["bufferViews"].back()["byteStride"] = 16;
  EXPECT_EQ(mesh_of(builder), mesh_of(GltfBuilder()));

  const std::uint8_t index = 2;
  const std::array<float, 3> point{1, 1, 5};
  builder.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", builder.add_view(&index, 1)}, {"componentType", 5121}}},
      {"values", {{"bufferView", builder.add_view(point.data(), 12)}}}};
  EXPECT_EQ(mesh_of(builder).points[2], glm::vec3(1, 1, 5));
}

TEST_F(Gltf, HasMaterials) {
  GltfBuilder builder;
  const std::string red = png(255, 0, 0);
  const std::string half = png(0, 128, 0);
  builder.json["images"] = {
      {{"bufferView", builder.add_view(red.data(), red.size())}, {"mimeType", "image/png"}},
      {{"bufferView", builder.add_view(half.data(), half.size())}, {"mimeType", "image/png"}}};
  builder.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
  builder.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
  builder.json["materials"] = {
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {0.1, 0.2, 0.3, 1.0}},
         {"metallicFactor", 0.25},
         {"roughnessFactor", 0.5},
         {"baseColorTexture", {{"index", 0}}},
         {"metallicRoughnessTexture", {{"index", 1}}}}},
       {"normalTexture", {{"index", 1}, {"scale", 0.75}}},
       {"emissiveTexture", {{"index", 1}}},
       {"emissiveFactor", {1.0, 0.5, 0.0}},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4.0}}}}}}};
  builder.primitive()["material"] = 0;
  const auto scene = read(builder);
  const Material& material = scene->parts.at(0).material;
  EXPECT_EQ(material.type, Material::Type::metallic_roughness);
  const MetallicRoughness& values = material.metallic_roughness;
  EXPECT_EQ(values.base_color, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(values.metallic, 0.25);
  EXPECT_EQ(values.roughness, 0.5);
  EXPECT_EQ(values.normal_scale, 0.75);
  EXPECT_EQ(values.emissive, glm::dvec3(4.0, 2.0, 0.0));
  EXPECT_EQ(values.base_color_texture.wrap_u, TextureWrap::clamp);
  EXPECT_EQ(values.base_color_texture.wrap_v, TextureWrap::mirror);
  EXPECT_EQ(values.normal_texture.wrap_u, TextureWrap::repeat);
  EXPECT_EQ(values.base_color_texture.content->average().r, 1.0f);
  // Colors are encoded, others are linear; an image is decoded once for each.
  EXPECT_NEAR(values.metallic_roughness_texture.content->average().g, 128.0 / 255.0, 1e-6);
  EXPECT_NEAR(values.emissive_texture.content->average().g, 0.2158605, 1e-5);
  EXPECT_EQ(values.normal_texture.content, values.metallic_roughness_texture.content);
}

TEST_F(Gltf, MaterialsAreGltfsWhereThereIsNone) {
  const auto scene = read(GltfBuilder());
  EXPECT_EQ(scene->parts.at(0).material.metallic_roughness, MetallicRoughness());
}

TEST_F(Gltf, TexturesAreTransformedAsTheExtensionSays) {
  GltfBuilder builder;
  builder.json["images"] = {{{"uri", "missing.png"}}};
  builder.json["textures"] = {{{"source", 0}}};
  const double angle = std::numbers::pi / 2;
  builder.json["materials"] = {
      {{"emissiveTexture",
        {{"index", 0},
         {"extensions",
          {{"KHR_texture_transform",
            {{"offset", {0.5, 0.25}}, {"rotation", angle}, {"scale", {2, 3}}}}}}}}}};
  builder.primitive()["material"] = 0;
  // With v down, counterclockwise turns u to -v and v to u.
  const MeshArrays mesh = mesh_of(builder);
  const glm::dvec2 first(0.5 + 3.0, 0.25);  // of (0, 1)
  EXPECT_NEAR(mesh.texcoords[0].x, first.x, 1e-6);
  EXPECT_NEAR(mesh.texcoords[0].y, 1.0 - first.y, 1e-6);
  const glm::dvec2 third(0.5, 0.25 - 2.0);  // of (1, 0)
  EXPECT_NEAR(mesh.texcoords[2].x, third.x, 1e-6);
  EXPECT_NEAR(mesh.texcoords[2].y, 1.0 - third.y, 1e-6);
  EXPECT_TRUE(contains(warnings_.at(0), "missing.png is missing"));
}

TEST_F(Gltf, HasCameras) {
  GltfBuilder builder;
  builder.json["cameras"] = {
      {{"type", "perspective"},
       {"perspective", {{"yfov", 0.8}, {"znear", 0.1}, {"aspectRatio", 2}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1.5}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 0}}}}};
  const double s = std::sqrt(0.5);
  builder.json["nodes"].push_back(
      {{"name", "eye"}, {"camera", 0}, {"translation", {5, 0.5, 0}}, {"rotation", {0, s, 0, s}}});
  builder.json["nodes"].push_back({{"name", "flat"}, {"camera", 1}});
  builder.json["nodes"].push_back({{"name", "nothing"}, {"camera", 2}});
  builder.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
  const auto scene = read(builder);
  ASSERT_EQ(scene->cameras.size(), 2u);
  const Camera& camera = scene->cameras[0].camera;
  EXPECT_EQ(scene->cameras[0].name, "eye");
  EXPECT_NEAR(camera.vertical_fov, 0.8 * 180.0 / std::numbers::pi, 1e-12);
  expect_near(camera.eye, {5, 0.5, 0});
  expect_near(camera.target, {0.5, 0.5, 0});  // as far as the middle of the square
  expect_near(camera.up, {0, 1, 0});
  // Twice ymag high, and from its node on.
  const Camera& flat = scene->cameras[1].camera;
  EXPECT_EQ(flat.height, 3.0);
  expect_near(flat.eye, {0, 0, 0});
  expect_near(glm::normalize(flat.target - flat.eye), {0, 0, -1});
  expect_only(warnings_, "the camera sees nothing");
}

TEST_F(Gltf, HasLights) {
  GltfBuilder builder;
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 683}},
      {{"type", "spot"},
       {"intensity", 1366},
       {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
      {{"type", "directional"}, {"intensity", 683}}};
  const auto add = [&builder](int light, const GltfBuilder::Json& rotation) {
    builder.json["nodes"].push_back(
        {{"name", "light " + std::to_string(light)},
         {"translation", {1, 2, 3}},
         {"rotation", rotation},
         {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    builder.json["scenes"][0]["nodes"].push_back(light + 1);
  };
  const double s = std::sqrt(0.5);
  add(0, {0, 0, 0, 1});
  add(1, {-s, 0, 0, s});  // from -z to -y
  add(2, {0, 0, 0, 1});
  const auto scene = read(builder);
  ASSERT_EQ(scene->lights.size(), 3u);
  expect_near(scene->lights[0].intensity, {1, 0.5, 0});
  expect_near(scene->lights[0].position, {1, 2, 3});
  EXPECT_EQ(scene->lights[0].name, "light 0");
  const light::Spot& cone = std::get<light::Spot>(scene->lights[1].kind);
  expect_near(scene->lights[1].intensity, glm::dvec3(2.0));
  expect_near(cone.direction, {0, -1, 0});
  EXPECT_NEAR(cone.inner_angle, 0.25 * 180.0 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(cone.outer_angle, 0.5 * 180.0 / std::numbers::pi, 1e-12);
  expect_near(std::get<light::Directional>(scene->lights[2].kind).direction, {0, 0, -1});
}

TEST_F(Gltf, SpotsMayHaveEqualAngles) {
  for (const double inner : {0.5, 0.6}) {
    GltfBuilder builder;
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", 0.5}}}}};
    builder.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    builder.json["scenes"][0]["nodes"].push_back(1);
    const auto scene = read(builder);
    ASSERT_EQ(scene->lights.size(), 1u);
    const light::Spot& cone = std::get<light::Spot>(scene->lights[0].kind);
    EXPECT_EQ(cone.inner_angle, cone.outer_angle) << inner;
    EXPECT_EQ(warnings_.empty(), inner == 0.5);
  }
}

TEST(ImportedName, IsOneThatAScenesObjectMayHave) {
  EXPECT_EQ(imported_name("a\nb\x7f", "?"), "ab");
  EXPECT_EQ(imported_name("\n", "?"), "?");
  EXPECT_EQ(imported_name(std::string(255, 'a') + "\xC3\xA4", "?"), std::string(255, 'a'));
}

}  // namespace
}  // namespace brume
