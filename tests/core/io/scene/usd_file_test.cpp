#include "core/io/scene/usd_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
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
  EXPECT_TRUE(contains(splats, "token purpose = \"proxy\""));
  EXPECT_TRUE(contains(splats, "sphericalHarmonicsDegree = 0"));
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
  EXPECT_TRUE(contains(animated, "positions.timeSamples = {"));
  EXPECT_TRUE(contains(animated, "1: [],"));
  EXPECT_TRUE(contains(animated, "sphericalHarmonicsCoefficients (\n            elementSize = 1"));
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
  EXPECT_TRUE(contains(light, "inputs:normalize = true"));
  EXPECT_TRUE(contains(light, "treatAsPoint = true"));
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
  EXPECT_TRUE(contains(text, "startTimeCode = 1"));
  EXPECT_TRUE(contains(text, "endTimeCode = 2"));
  EXPECT_TRUE(contains(text, "timeCodesPerSecond = 24"));
  const std::string camera = prim(text, "Camera");
  EXPECT_TRUE(contains(camera, "xformOp:transform.timeSamples = {"));
  EXPECT_TRUE(contains(camera, "focalLength = "));  // stays
  const std::string density = prim(text, "density");
  EXPECT_TRUE(contains(density, "1: @fog_1.vdb@"));
  EXPECT_TRUE(contains(density, "2: @fog_2.vdb@"));
  EXPECT_TRUE(contains(text, "rel field:density = </World/Fog/density>"));
}

// A farm's task writes one, to be put together with others.
TEST_F(UsdFile, OneFrameOfASequenceHasItsTimeCode) {
  const std::string text = stage({{48, scene_, "fog_48.vdb"}});
  for (const char* line : {"startTimeCode = 48\n", "endTimeCode = 48\n",
                           "timeCodesPerSecond = 24\n", "48: @fog_48.vdb@,\n"}) {
    EXPECT_TRUE(contains(text, line));
  }
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

}  // namespace
}  // namespace brume
