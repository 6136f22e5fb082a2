#include "core/io/scene/usd_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "brume/at_time.h"
#include "brume/error.h"
#include "brume/mesh_arrays.h"
#include "brume/primitive.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/texture_file.h"
#include "core/io/scene/usd_text.h"
#include "core/number_domain.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/materials/texture.h"
#include "tests/contains.h"
#include "tests/core/io/scene/usd_stage.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

TEST_F(UsdFile, HasSplatsWhereFramesHaveThem) {
  EXPECT_FALSE(contains(stage(), "ParticleField"));
  EXPECT_FALSE(contains(stage(), "purpose"));
  Gaussian g{{1.0, 2.0, 3.0}, 1.0};
  g.set_radii(std::numbers::sqrt2 * glm::dvec3(0.5, 0.25, 0.125), {0.5, 0.5, -0.5, 0.5});
  g.density = std::log(4.0) * std::numbers::inv_sqrtpi / g.mean_radius();
  Gaussian black = g;
  black.optics.albedo = glm::dvec3(1e-6);
  scene_.optics.albedo = glm::dvec3(1.0);
  UsdFrame frame{{}, scene_, {}};
  frame.splats = {g, black};
  const std::string all = stage({frame});
  EXPECT_TRUE(contains(prim(all, "Fog"), "token purpose = \"render\""));
  const std::string splats = prim(all, "Fog_splats");
  EXPECT_TRUE(splats.find("def ParticleField3DGaussianSplat") != std::string::npos) << splats;
  EXPECT_TRUE(contains(splats, "token purpose = \"proxy\"", "sphericalHarmonicsDegree = 0"));
  const auto expect = [&](const char* attribute, const std::vector<double>& expected) {
    const std::vector<double> found = numbers(splats, attribute);
    ASSERT_EQ(found.size(), expected.size()) << attribute;
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-4);
  };
  const double full = 0.5 / 0.28209479177387814;
  expect("positions", {1, 2, 3, 1, 2, 3});
  expect("scales", {0.5, 0.25, 0.125, 0.5, 0.25, 0.125});
  expect("orientations", {0.5, 0.5, -0.5, 0.5, 0.5, 0.5, -0.5, 0.5});
  expect("opacities", {0.75, 0.75});
  expect("Coefficients", {full, full, full, -full, -full, -full});

  // Some at each time, none at the last.
  frame.frame = 0;
  UsdFrame empty{1, scene_, {}};
  const std::string animated = prim(stage({frame, empty}), "Fog_splats");
  EXPECT_TRUE(contains(animated, "positions.timeSamples = {", "1: [],",
                       "sphericalHarmonicsCoefficients (\n            elementSize = 1"));
}

TEST_F(UsdFile, CameraSeesWhatBrumeSees) {
  const std::string camera = prim(stage(), "Camera");
  const double height = numbers(camera, "verticalAperture")[0];
  EXPECT_NEAR(numbers(camera, "horizontalAperture")[0], 2.0 * height, 1e-9);
  const double focal = numbers(camera, "focalLength")[0];
  EXPECT_NEAR(std::atan(0.5 * height / focal), std::numbers::pi / 6.0, 1e-12);
  // Looking along -z from the eye: no rotation.
  const std::vector<double> expected{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 5, 1};
  const std::vector<double> found = numbers(camera, "xformOp:transform");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

// Apertures are tenths of a unit.
TEST_F(UsdFile, OrthographicCamerasSeeWhatBrumeSees) {
  scene_.camera.height = 3.0;
  const std::string camera = prim(stage(), "Camera");
  EXPECT_TRUE(contains(camera, "token projection = \"orthographic\""));
  EXPECT_NEAR(numbers(camera, "verticalAperture")[0], 30.0, 1e-9);
  EXPECT_NEAR(numbers(camera, "horizontalAperture")[0], 60.0, 1e-9);
  EXPECT_FALSE(contains(camera, "focalLength"));
}

TEST_F(UsdFile, CameraRolls) {
  scene_.camera.roll = 90.0;
  const std::vector<double> found = numbers(prim(stage(), "Camera"), "xformOp:transform");
  const std::vector<double> expected{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 5, 1};
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

// Radiant intensity pi r^2 L of a normalized sphere, whose L is intensity / (4 pi r^2).
TEST_F(UsdFile, PointLightsKeepTheirIntensity) {
  scene_.lights = {{{1.0, 2.0, 3.0}, {8.0, 4.0, 2.0}}};
  const std::string light = prim(stage(), "Point_light");
  ASSERT_TRUE(contains(light, "SphereLight"));
  EXPECT_NEAR(numbers(light, "inputs:intensity")[0] / 4.0, 8.0, 1e-12);
  EXPECT_EQ(numbers(light, "inputs:color"), (std::vector{1.0, 0.5, 0.25}));
  EXPECT_TRUE(contains(light, "inputs:normalize = true", "treatAsPoint = true"));
}

TEST_F(UsdFile, OtherLightsKeepShapeAndDirection) {
  Light spot{{0.0, 3.0, 0.0}, {2.0, 2.0, 2.0}, light::Spot{{0.0, -1.0, 0.0}, 10.0, 40.0}};
  spot.name = "Lamp";
  Light sun;
  sun.kind = light::Directional{{1.0, 0.0, 0.0}, 0.5};
  sun.intensity = {3.0, 3.0, 3.0};
  Light panel;
  panel.kind = light::Rectangle{.width = 2.0, .two_sided = true};
  panel.on = false;
  scene_.lights = {spot, sun, panel};
  const std::string text = stage();
  const std::string lamp = prim(text, "Lamp");
  EXPECT_TRUE(contains(lamp, "ShapingAPI"));
  EXPECT_EQ(numbers(lamp, "shaping:cone:angle"), std::vector{40.0});
  EXPECT_EQ(numbers(lamp, "shaping:cone:softness"), std::vector{0.75});
  const std::vector<double> down = numbers(lamp, "xformOp:transform");  // -z of the light is -y
  EXPECT_NEAR(down[9], 1.0, 1e-12);
  const std::string distant = prim(text, "Sun");
  EXPECT_EQ(numbers(distant, "inputs:angle"), std::vector{0.5});
  EXPECT_EQ(numbers(distant, "inputs:intensity"), std::vector{3.0});
  EXPECT_NEAR(numbers(distant, "xformOp:transform")[8], -1.0, 1e-12);
  const std::string area = prim(text, "Area_light");
  EXPECT_TRUE(contains(area, "RectLight"));
  EXPECT_EQ(numbers(area, "inputs:width"), std::vector{2.0});
  EXPECT_EQ(numbers(area, "inputs:intensity"), std::vector{0.0});  // switched off
  EXPECT_TRUE(contains(area, "brume:twoSided = true"));
}

// OpenEXR's maps, which USD follows, have +z in the middle.
TEST_F(UsdFile, EnvironmentIsTurnedToUsd) {
  Environment environment;
  environment.file = folder_ / "sky.exr";
  environment.rotation = 30.0;
  environment.intensity = 2.0;
  environment.map = std::make_shared<RadianceMap>(RadianceMap{2, 1, {{}, {}}});
  scene_.environment = environment;
  const std::string dome = prim(stage(), "Environment");
  EXPECT_TRUE(contains(dome, "@sky.exr@"));
  EXPECT_EQ(numbers(dome, "inputs:intensity"), std::vector{2.0});
  const std::vector<double> turn = numbers(dome, "xformOp:transform");
  EXPECT_NEAR(turn[0], std::cos(210.0 * std::numbers::pi / 180.0), 1e-12);
  EXPECT_NEAR(turn[8], std::sin(210.0 * std::numbers::pi / 180.0), 1e-12);
}

// Such a sky has no file, so its light is even; its sun is a light.
TEST_F(UsdFile, SkyIsEvenLightAndASun) {
  scene_.environment.emplace().sky = Sky{.elevation = 40.0};
  scene_ = evaluate_at(scene_, 0.0);
  const std::string text = stage();
  const std::string dome = prim(text, "Environment");
  EXPECT_FALSE(contains(dome, "texture"));
  const std::vector<double> color = numbers(dome, "inputs:color");
  ASSERT_EQ(color.size(), 3U);
  EXPECT_GT(color[2], 1.0);
  EXPECT_LT(color[2], 20.0);
  EXPECT_GT(numbers(prim(text, "Sun"), "inputs:intensity")[0], 100.0);
}

TEST_F(UsdFile, WhatMovesHasTimeSamples) {
  std::vector<UsdFrame> frames;
  for (const int frame : {1, 2}) {
    scene_.camera.eye.z = 5.0 + frame;
    frames.push_back({frame, scene_, "fog_" + std::to_string(frame) + ".vdb"});
  }
  const std::string text = stage(frames);
  EXPECT_TRUE(contains(text, "startTimeCode = 1", "endTimeCode = 2", "timeCodesPerSecond = 24"));
  const std::string camera = prim(text, "Camera");
  EXPECT_TRUE(contains(camera, "xformOp:transform.timeSamples = {", "focalLength = "));  // stays
  const std::string density = prim(text, "density");
  EXPECT_TRUE(contains(density, "1: @fog_1.vdb@", "2: @fog_2.vdb@"));
  EXPECT_TRUE(contains(text, "rel field:density = </World/Fog/density>"));
}

// A farm's task writes one, to be put together with others.
TEST_F(UsdFile, OneFrameOfASequenceHasItsTimeCode) {
  const std::string text = stage({{48, scene_, "fog_48.vdb"}});
  EXPECT_TRUE(contains(text, "startTimeCode = 48\n", "endTimeCode = 48\n",
                       "timeCodesPerSecond = 24\n", "48: @fog_48.vdb@,\n"));
  EXPECT_TRUE(contains(prim(text, "Camera"), "float focalLength.timeSamples = {"));
  EXPECT_FALSE(contains(stage(), "timeCode")) << "a moment alone";
}

TEST(UsdText, QuotesWhatNeedsIt) {
  EXPECT_EQ(usd_string("a \"b\" \\ c"), R"("a \"b\" \\ c")");
  EXPECT_EQ(usd_asset("a.vdb"), "@a.vdb@");
  EXPECT_EQ(usd_asset("a@b.vdb"), "@@@a@b.vdb@@@");
  UsdText text({0});
  EXPECT_EQ(text.open("Xform", "1 \xc3\xa4"), "/_1___");
}

// Surfaces, their copies and materials in stages of USD.

using UsdSurface = UsdFile;

Surface placed_box(const std::string& name) {
  Surface box;
  box.name = name;
  box.primitive = Primitive{};
  box.mesh = mesh_of(*box.primitive);
  box.translate = {1.0, 2.0, 3.0};
  box.scale = 2.0;
  return box;
}

TEST_F(UsdSurface, SurfacesAreMeshesInTheirPlaces) {
  Surface box = placed_box("A \"box\"");
  box.material.reflectance = {0.1, 0.2, 0.3};
  scene_.surfaces = {box, box};
  const std::string text = stage();
  const std::string first = prim(text, "A__box_");
  EXPECT_TRUE(contains(first, R"(displayName = "A \"box\"")")) << first.substr(0, 300);
  EXPECT_FALSE(prim(text, "A__box__2").empty());  // names are told apart
  EXPECT_EQ(numbers(first, "xformOp:transform"),
            (std::vector<double>{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 2, 3, 1}));
  const std::size_t triangles = numbers(first, "faceVertexCounts").size();
  const std::vector<double> indices = numbers(first, "faceVertexIndices");
  const std::size_t points = numbers(first, "points").size() / 3;
  EXPECT_GT(triangles, 0u);
  EXPECT_EQ(indices.size(), 3 * triangles);
  EXPECT_EQ(numbers(first, "normals").size(), 3 * points);
  EXPECT_LT(*std::ranges::max_element(indices), points);
  EXPECT_EQ(numbers(first, "inputs:diffuseColor"), (std::vector{0.1, 0.2, 0.3}));
}

TEST_F(UsdSurface, CopiesAreInstances) {
  Surface box = placed_box("Box");
  // Four times as large as the box, with its corner x = 0.5 at 6.
  box.placed_copies =
      std::make_shared<const CopyPlacements>(CopyPlacements{{{2.0, 0.0, 0.0}, {1, 0, 0, 0}, 8.0}});
  scene_.surfaces = {box};
  const std::string copies = prim(stage(), "Box_copies");
  EXPECT_TRUE(contains(copies, "rel prototypes = </World/Box>"));
  EXPECT_EQ(numbers(copies, "protoIndices"), std::vector{0.0});
  EXPECT_EQ(numbers(copies, "scales"), (std::vector{4.0, 4.0, 4.0}));
  EXPECT_EQ(numbers(copies, "orientations"), (std::vector{1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(numbers(copies, "positions"), (std::vector{-2.0, -8.0, -12.0}));
}

// A copy stays where it is while the prototype, of which it is an instance, moves.
TEST_F(UsdSurface, CopiesAreWhereTheyAreInEachFrame) {
  Surface box;
  box.name = "Box";
  box.mesh = mesh_of(Primitive{});
  box.placed_copies =
      std::make_shared<const CopyPlacements>(CopyPlacements{{{2.0, 0.0, 0.0}, {1, 0, 0, 0}, 2.0}});
  scene_.surfaces = {box};
  std::vector<UsdFrame> frames{{1, scene_, {}}, {2, scene_, {}}, {3, scene_, {}}};
  frames[2].scene.surfaces[0].translate = {0.0, 3.0, 0.0};
  const std::string moving = prim(stage(frames), "Box_copies");
  EXPECT_TRUE(contains(moving, "positions.timeSamples = {", "1: [(2, 0, 0)],", "2: [(2, 0, 0)],",
                       "3: [(2, -6, 0)],", "scales = [(2, 2, 2)]"));
  frames[2] = frames[1];
  frames[2].frame = 3;
  EXPECT_FALSE(contains(prim(stage(frames), "Box_copies"), "timeSamples"));
  // A stage of one frame, which others put together, has a time sample of all that may move.
  EXPECT_TRUE(contains(prim(stage({frames[1]}), "Box_copies"), "2: [(2, 0, 0)],"));
}

TEST_F(UsdSurface, MeshesBendFromFrameToFrame) {
  Surface box;
  box.name = "Box";
  box.mesh = mesh_of(Primitive{});
  scene_.surfaces = {box};
  std::vector<UsdFrame> frames{{1, scene_, {}}, {2, scene_, {}}};
  EXPECT_TRUE(contains(prim(stage(frames), "Box"), "points = ["));
  MeshArrays bent = to_arrays(*box.mesh);
  bent.points[0] = {7.0f, 8.0f, 9.0f};
  frames[1].scene.surfaces[0].mesh = to_mesh(bent);
  const std::string mesh = prim(stage(frames), "Box");
  EXPECT_TRUE(contains(mesh, "points.timeSamples = {", "2: [(7, 8, 9), "));
  EXPECT_TRUE(contains(mesh, "normals = [")) << "which stay";
}

TEST_F(UsdSurface, CornersWithoutNormalsHaveThoseOfTheirTriangles) {
  Surface bend;
  bend.name = "Bend";
  bend.mesh = to_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                       {{0, 0, 0}, {0, 0.6f, 0.8f}, {0, 0, 1}, {0, 1, 0}},
                       {{0, 1, 2}, {0, 3, 1}}});
  scene_.surfaces = {bend};
  const std::string mesh = prim(stage(), "Bend");
  EXPECT_TRUE(contains(mesh, "faceVarying"));
  const std::vector<double> normals = numbers(mesh, "normals");
  ASSERT_EQ(normals.size(), 18u);
  const auto normal = [&](std::size_t corner) {
    return glm::vec3(normals[3 * corner], normals[3 * corner + 1], normals[3 * corner + 2]);
  };
  EXPECT_EQ(normal(0), glm::vec3(0, 0, 1));
  EXPECT_EQ(normal(1), glm::vec3(0, 0.6f, 0.8f));
  EXPECT_EQ(normal(3), glm::vec3(0, 1, 0));
}

TEST_F(UsdSurface, MaterialsKeepHolesAndPanes) {
  Surface box;
  box.name = "Box";
  box.primitive = Primitive{};
  box.mesh = mesh_of(*box.primitive);
  box.material.type = Material::Type::metallic_roughness;
  MetallicRoughness& m = box.material.metallic_roughness;
  m.alpha = AlphaMode::cutout;
  m.opacity = 0.75;
  m.alpha_cutoff = 0.25;
  scene_.surfaces = {box};
  std::string shader = prim(prim(stage(), "Box"), "Shader");
  EXPECT_EQ(numbers(shader, "inputs:opacity"), std::vector{0.75});
  EXPECT_EQ(numbers(shader, "inputs:opacityThreshold"), std::vector{0.25});
  // Within a file of another kind.
  const std::vector<std::uint8_t> texels{10, 20, 30, 255, 40, 50, 60, 0};
  scene_.surfaces[0].material.metallic_roughness.base_color_texture = {
      folder_ / "model.glb", std::make_shared<Texture>(2, 1, texels, Texture::Encoding::srgb)};
  const std::string mesh = prim(stage(), "Box");
  EXPECT_TRUE(contains(prim(mesh, "Shader"),
                       "opacity.connect = </World/Box/Material/BaseColor.outputs:a>"));
  EXPECT_EQ(numbers(prim(mesh, "BaseColor"), "inputs:scale"), (std::vector{1.0, 1.0, 1.0, 0.75}));
  const auto written = read_texture(folder_ / "a_texture_1.png", true);
  EXPECT_EQ(written->texel(written->levels()[0], 1, 0).a, 0.0f);
  MetallicRoughness& pane = scene_.surfaces[0].material.metallic_roughness;
  pane = {};
  pane.transmission = {0.25, 0.5, 0.75};
  shader = prim(prim(stage(), "Box"), "Shader");
  EXPECT_EQ(numbers(shader, "inputs:opacity"), std::vector{0.5});
}

TEST_F(UsdSurface, MaterialsKeepTheirValuesAndTextures) {
  Surface box;
  box.name = "Box";
  box.primitive = Primitive{};
  MeshArrays arrays = to_arrays(*mesh_of(*box.primitive));
  arrays.texcoords.assign(arrays.points.size(), {0.25f, 0.75f});
  box.mesh = to_mesh(arrays);
  box.material.type = Material::Type::metallic_roughness;
  MetallicRoughness& m = box.material.metallic_roughness;
  m.base_color = {0.5, 0.25, 1.0};
  m.metallic = 0.75;
  m.roughness = 0.5;
  m.emissive = {1.0, 2.0, 3.0};
  // Two texels, within a file of another kind.
  const std::vector<std::uint8_t> texels{10, 20, 30, 255, 40, 50, 60, 255};
  m.base_color_texture.file = folder_ / "model.glb";
  m.base_color_texture.content = std::make_shared<Texture>(2, 1, texels, Texture::Encoding::srgb);
  m.metallic_roughness_texture.file = folder_ / "rough.png";
  m.metallic_roughness_texture.wrap_u = TextureWrap::mirror;
  m.metallic_roughness_texture.content =
      std::make_shared<Texture>(2, 1, texels, Texture::Encoding::linear);
  scene_.surfaces = {box};
  const std::string mesh = prim(stage(), "Box");
  EXPECT_EQ(numbers(mesh, "primvars:st").size(), 2 * arrays.points.size());
  const std::string shader = prim(mesh, "Shader");
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string material = "</World/Box/Material/";
  EXPECT_TRUE(has(shader, "diffuseColor.connect = " + material + "BaseColor.outputs:rgb>"));
  EXPECT_TRUE(has(shader, "roughness.connect = " + material + "MetallicRoughness.outputs:g>"));
  EXPECT_TRUE(has(shader, "metallic.connect = " + material + "MetallicRoughness.outputs:b>"));
  EXPECT_EQ(numbers(shader, "inputs:emissiveColor"), (std::vector{1.0, 2.0, 3.0}));
  const std::string color = prim(mesh, "BaseColor");
  EXPECT_TRUE(has(color, "@a_texture_1.png@") && has(color, "\"sRGB\""));
  EXPECT_EQ(numbers(color, "inputs:scale"), (std::vector{0.5, 0.25, 1.0, 1.0}));
  const std::string pair = prim(mesh, "MetallicRoughness");
  EXPECT_TRUE(has(pair, "@rough.png@") && has(pair, "\"raw\"") && has(pair, "\"mirror\""));
  EXPECT_EQ(numbers(pair, "inputs:scale"), (std::vector{1.0, 0.5, 0.75, 1.0}));
  const auto image = decode_texture("a", read_bytes(folder_ / "a_texture_1.png"), true);
  EXPECT_TRUE(std::ranges::equal(image->texels(), m.base_color_texture.content->texels()));
  // Who must not be written over is asked first.
  std::filesystem::remove(folder_ / "a_texture_1.png");
  const UsdFrame frame{{}, scene_, {}};
  const auto refuse = [](const std::filesystem::path& file) { throw InputError(file, "", "no"); };
  EXPECT_THROW(write_usd(folder_ / "a.usda", {&frame, 1}, 24.0, OpacityAlong::mean, refuse),
               InputError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a_texture_1.png"));
}

TEST_F(UsdSurface, MeshesKeepColorsAndSecondTexcoords) {
  Surface box;
  box.name = "Box";
  MeshArrays arrays = to_arrays(*mesh_of(Primitive{}));
  const std::size_t count = arrays.points.size();
  arrays.texcoords.assign(count, {0.25f, 0.75f});
  arrays.second_texcoords.assign(count, {0.5f, 0.5f});
  arrays.colors.assign(count, {1.0f, 0.5f, 0.25f, 1.0f});
  box.mesh = to_mesh(arrays);
  box.material.type = Material::Type::metallic_roughness;
  MetallicRoughness& m = box.material.metallic_roughness;
  m.base_color = {0.5, 0.5, 1.0};
  const std::vector<std::uint8_t> texels{10, 20, 30, 255};
  m.emissive_texture.file = folder_ / "glow.png";
  m.emissive_texture.content = std::make_shared<Texture>(1, 1, texels, Texture::Encoding::srgb);
  m.emissive_texture.uses_second_texcoords = true;
  scene_.surfaces = {box};
  const std::string mesh = prim(stage(), "Box");
  EXPECT_EQ(numbers(mesh, "primvars:st1").size(), 2 * count);
  const std::vector<double> colors = numbers(mesh, "primvars:displayColor");
  ASSERT_EQ(colors.size(), 3 * count);
  EXPECT_EQ(colors[0], 0.5);
  EXPECT_EQ(colors[1], 0.25);
  EXPECT_EQ(colors[2], 0.25);
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string material = "</World/Box/Material/";
  EXPECT_TRUE(
      has(prim(mesh, "Shader"), "diffuseColor.connect = " + material + "Colors.outputs:result>"));
  EXPECT_TRUE(has(prim(mesh, "Colors"), "\"displayColor\""));
  EXPECT_TRUE(has(prim(mesh, "Emissive"),
                  "st.connect = " + material + "SecondCoordinates.outputs:result>"));
  EXPECT_TRUE(has(prim(mesh, "SecondCoordinates"), "\"st1\""));
}

TEST_F(UsdSurface, TexturesHaveTheMeanOfTheColorsOfVertices) {
  Surface box;
  box.name = "Box";
  MeshArrays arrays = to_arrays(*mesh_of(Primitive{}));
  const std::size_t count = arrays.points.size();
  arrays.texcoords.assign(count, {0.25f, 0.75f});
  arrays.colors.assign(count, {1.0f, 0.5f, 0.25f, 0.5f});
  for (std::size_t i = 0; i < count / 2; ++i) arrays.colors[i] = glm::vec4(0.0f);
  box.mesh = to_mesh(arrays);
  box.material.type = Material::Type::metallic_roughness;
  MetallicRoughness& m = box.material.metallic_roughness;
  m.base_color = {0.5, 0.5, 1.0};
  m.opacity = 0.5;
  m.alpha = AlphaMode::blend;
  scene_.surfaces = {box};
  const std::string colored = prim(stage(), "Box");
  EXPECT_TRUE(contains(prim(colored, "Shader"), "inputs:opacity.connect"));
  const std::vector<double> opacities = numbers(colored, "primvars:displayOpacity");
  ASSERT_EQ(opacities.size(), count);
  EXPECT_EQ(opacities.front(), 0.0);
  EXPECT_EQ(opacities.back(), 0.25);
  const std::vector<std::uint8_t> texels{10, 20, 30, 255};
  MetallicRoughness& textured = scene_.surfaces[0].material.metallic_roughness;
  textured.base_color_texture.file = folder_ / "paint.png";
  textured.base_color_texture.content =
      std::make_shared<Texture>(1, 1, texels, Texture::Encoding::srgb);
  EXPECT_EQ(numbers(prim(stage(), "BaseColor"), "inputs:scale"),
            (std::vector{0.25, 0.125, 0.125, 0.125}));
}

TEST_F(UsdSurface, PhongLobesKeepTheirWidth) {
  Surface box;
  box.name = "Box";
  box.primitive = Primitive{};
  box.mesh = mesh_of(*box.primitive);
  box.material.type = Material::Type::phong;
  box.material.specular = {0.1, 0.2, 0.3};
  box.material.exponent = 126.0;
  scene_.surfaces = {box};
  const std::string shader = prim(stage(), "Shader");
  EXPECT_EQ(numbers(shader, "inputs:specularColor"), (std::vector{0.1, 0.2, 0.3}));
  const double alpha = numbers(shader, "inputs:roughness").at(0);
  EXPECT_NEAR(std::pow(alpha, 4), 2.0 / 128.0, 1e-9);
}

}  // namespace

}  // namespace brume
