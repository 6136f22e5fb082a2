// Splats of glTF, written and read.

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/io/gaussians/gaussian_file.h"
#include "core/io/import/gltf_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/medium/splat.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/gaussians/random_ellipsoids.h"
#include "tests/core/io/gaussians/splat_gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

// The depth of a splat of float opacity has as many digits as its transmittance.
double depth_precision(const Gaussian& g, OpacityAlong along) {
  return 1e-6 * g.density + 1e-7 * g.density * std::exp(depth_along(g, along)) /
                                std::max(depth_along(g, along), 1e-12);
}

using SplatGltf = FolderTest;

TEST_F(SplatGltf, GivesBackShapesAndDensities) {
  std::vector<Gaussian> gaussians = random_ellipsoids(200);
  for (Gaussian& g : gaussians) g.density = std::min(g.density, 2.0 / g.radius);
  for (const OpacityAlong along :
       {OpacityAlong::shortest, OpacityAlong::mean, OpacityAlong::longest}) {
    for (const char* name : {"a.glb", "a.gltf"}) {
      write_splats(folder_ / name, gaussians, {along});
      const std::vector<Gaussian> back =
          read_gaussians(folder_ / name, nullptr, limits::gaussians, {along});
      ASSERT_EQ(back.size(), gaussians.size());
      EXPECT_EQ(max_gaussian_count(folder_ / name), gaussians.size());
      for (std::size_t i = 0; i < back.size(); ++i) {
        EXPECT_LT(shape_difference(back[i], gaussians[i]), 2e-5) << i;
        EXPECT_NEAR(back[i].density, gaussians[i].density, depth_precision(gaussians[i], along));
      }
    }
  }
}

TEST_F(SplatGltf, ColorsAreEncodedOrLinear) {
  SplatGltfBuilder builder;
  const auto albedo = [&] {
    const auto file = folder_.write("a.glb", builder.binary());
    return read_gaussians(file, nullptr, limits::gaussians, {.has_albedos = true})
        .at(0)
        .optics.albedo;
  };
  EXPECT_LT(glm::length(*albedo() - glm::dvec3(0.21404114048223255)), 1e-9);
  builder.extension()["colorSpace"] = "lin_rec709_display";
  EXPECT_EQ(albedo(), glm::dvec3(0.5));
  builder.extension()["colorSpace"] = "mauve";
  const std::string error = error_of(albedo);
  EXPECT_TRUE(contains(error, "colorSpace") && contains(error, "mauve"));
  EXPECT_EQ(read_gaussians(folder_ / "a.glb").size(), 2u);
  builder.attributes().erase("KHR_gaussian_splatting:SH_DEGREE_0_COEF_0");
  EXPECT_FALSE(albedo().has_value());
}

TEST_F(SplatGltf, IsWhatTheExtensionSays) {
  Gaussian g{{1.0, 2.0, 3.0}, 1.0};
  g.set_radii(std::sqrt(2.0) * glm::dvec3(0.5, 0.25, 0.125), glm::dquat(0.5, 0.5, -0.5, 0.5));
  set_depth_along(g, std::log(4.0), OpacityAlong::mean);
  write_splats(folder_ / "a.gltf", std::vector{g, g});
  const Json json = Json::parse(content_of(folder_ / "a.gltf"));
  EXPECT_EQ(json["extensionsUsed"], Json({"KHR_gaussian_splatting"}));
  const Json& primitive = json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["mode"], 0);
  EXPECT_EQ(primitive["extensions"]["KHR_gaussian_splatting"]["kernel"], "ellipse");
  EXPECT_EQ(primitive["extensions"]["KHR_gaussian_splatting"]["colorSpace"], "srgb_rec709_display");
  EXPECT_EQ(primitive["attributes"].size(), 5u);
  EXPECT_EQ(json["accessors"][0]["min"], Json({1.0, 2.0, 3.0}));
  std::vector<std::string> warned;
  GltfFile file(folder_ / "a.gltf", warned);
  const JsonPath path;
  EXPECT_EQ(file.numbers(path, 1, 4)[3], 0.5f);
  EXPECT_EQ(file.numbers(path, 1, 4)[1], -0.5f);
  EXPECT_EQ(file.numbers(path, 2, 3)[1], 0.25f);
  EXPECT_EQ(file.numbers(path, 3, 1)[0], 0.75f);
  EXPECT_NEAR(file.numbers(path, 4, 3)[0], 0.5 / 0.28209479177387814, 1e-6);

  // No list of glTF may be empty.
  for (const char* name : {"none.glb", "none.gltf"}) {
    write_splats(folder_ / name, {});
    EXPECT_TRUE(read_gaussians(folder_ / name).empty());
    EXPECT_FALSE(contains(content_of(folder_ / name), "[]"));
  }
}

// A splat stays as opaque, and becomes the ellipsoid that the node makes of it.
TEST_F(SplatGltf, NodesPlaceSplats) {
  SplatGltfBuilder builder;
  builder.json["nodes"] = {
      {{"children", {1, 2}}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}},
      {{"mesh", 0}},
      {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, -3, 0, 0, 0, 1, 1, 0, 0, 0, 5, 1}}}};
  const std::vector<Gaussian> found = read_gaussians(folder_.write("a.glb", builder.binary()));
  ASSERT_EQ(found.size(), 4u);
  const Gaussian expected = gaussian_of(SplatGltfBuilder::second());
  const glm::dmat4 uniform =
      glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(1.0, 2.0, 3.0)), glm::dvec3(2.0));
  glm::dmat4 sheared(1.0);
  sheared[1] = {0.0, -3.0, 0.0, 0.0};
  sheared[2] = {0.0, 1.0, 1.0, 0.0};
  sheared[3] = {0.0, 0.0, 5.0, 1.0};
  for (int node = 0; node < 2; ++node) {
    const glm::dmat4 map = node == 0 ? uniform : uniform * sheared;
    Gaussian placed = expected;
    placed.center = map * glm::dvec4(expected.center, 1.0);
    transform(placed, glm::dmat3(map));
    const Gaussian& g = found[static_cast<std::size_t>(2 * node + 1)];
    EXPECT_LT(shape_difference(g, placed), 1e-6);
    EXPECT_NEAR(depth_along(g, OpacityAlong::mean), depth_along(expected, OpacityAlong::mean),
                1e-12);
  }
}

// Files that are made small have them.
TEST_F(SplatGltf, ReadsIntegersAndOpacityOne) {
  SplatGltfBuilder builder;
  builder.set("OPACITY", builder.add_normalized<std::uint8_t>({51, 255}, "SCALAR"));
  builder.set("SCALE", builder.add_integers<std::uint8_t>({1, 2, 3, 4, 4, 4}, "VEC3"));
  builder.set("ROTATION",
              builder.add_normalized<std::int16_t>({0, 0, 32767, 0, 0, 0, 0, 32767}, "VEC4"));
  const std::vector<Gaussian> found = read_gaussians(folder_.write("a.glb", builder.binary()));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(glm::length(found[0].radii() - std::sqrt(2.0) * glm::dvec3(1, 2, 3)), 1e-14);
  EXPECT_NEAR(depth_along(found[0], OpacityAlong::mean), -std::log(0.8), 1e-7);
  EXPECT_NEAR(depth_along(found[1], OpacityAlong::mean), 25.0 * std::log(2.0), 1e-6);
  EXPECT_LT(glm::length(found[0].shape.rotation * glm::dvec3(1, 0, 0) - glm::dvec3(-1, 0, 0)),
            1e-12);
  EXPECT_TRUE(found[1].is_ball());
}

TEST_F(SplatGltf, AreLeftOutOfScenesWithAWarning) {
  std::vector<std::string> warned;
  SplatGltfBuilder builder;
  builder.json["extensionsRequired"] = {"KHR_gaussian_splatting"};
  const auto scene = read_imported_scene(folder_.write("a.glb", builder.binary()), warned);
  expect_only(warned, "read as Gaussians");
}

TEST_F(SplatGltf, AreFoundWhetherOrNotTheyCanBeRead) {
  const auto has = [&](const GltfBuilder& builder) {
    return has_splats(folder_.write("a.glb", builder.binary()));
  };
  SplatGltfBuilder splats;
  EXPECT_TRUE(has(splats));
  splats.json.erase("extensionsUsed");
  EXPECT_TRUE(has(splats));
  splats.extension()["extensions"]["KHR_gaussian_splatting_compression_spz_2"]["bufferView"] = 0;
  EXPECT_TRUE(has(splats));
  GltfBuilder square;
  EXPECT_FALSE(has(square));
  square.json["meshes"].push_back(1);
  square.json["meshes"].push_back({{"primitives", {1, {{"extensions", "x"}}}}});
  EXPECT_FALSE(has(square));
  write_splats(folder_ / "empty.gltf", {});
  EXPECT_TRUE(has_splats(folder_ / "empty.gltf"));
}

}  // namespace
}  // namespace brume
