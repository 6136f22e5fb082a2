// Splats of glTF, written and read.

#include <gtest/gtest.h>

#include <cstring>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

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

// Gaussians written as splats, and read back.

constexpr OpacityAlong every_opacity_along[] = {OpacityAlong::shortest, OpacityAlong::mean,
                                                OpacityAlong::longest};

using SplatFile = FolderTest;

TEST_F(SplatFile, PlyGivesBackShapesAndDensities) {
  const std::vector<Gaussian> gaussians = random_ellipsoids(200);
  for (const OpacityAlong along : every_opacity_along) {
    write_splats(folder_ / "a.ply", gaussians, {along});
    const std::vector<Gaussian> back =
        read_gaussians(folder_ / "a.ply", nullptr, limits::gaussians, {along});
    ASSERT_EQ(back.size(), gaussians.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
      EXPECT_LT(shape_difference(back[i], gaussians[i]), 2e-5) << i;
      EXPECT_NEAR(back[i].density, gaussians[i].density, 2e-6 * gaussians[i].density) << i;
    }
  }
}

TEST_F(SplatFile, ColorsBecomeAlbedosIfWanted) {
  std::vector<Gaussian> gaussians = random_ellipsoids(20);
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    const double x = static_cast<double>(i) / 19.0;
    gaussians[i].optics.albedo = glm::max(glm::dvec3(x, 1.0 - x, 0.002 * x), 1e-6);
  }
  for (const char* name : {"a.ply", "a.glb", "a.gltf"}) {
    write_splats(folder_ / name, gaussians);
    const auto plain = read_gaussians(folder_ / name);
    const auto back =
        read_gaussians(folder_ / name, nullptr, limits::gaussians, {.has_albedos = true});
    ASSERT_EQ(back.size(), gaussians.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
      EXPECT_FALSE(plain[i].optics.albedo.has_value());
      ASSERT_TRUE(back[i].optics.albedo.has_value());
      EXPECT_LT(glm::length(*back[i].optics.albedo - *gaussians[i].optics.albedo), 1e-6) << name;
    }
    write_gaussians(folder_ / "a.csv", back);
    EXPECT_EQ(read_gaussians(folder_ / "a.csv"), back);
  }
}

TEST_F(SplatFile, ColorsOfPlyMayBeMissingOrBeyondAlbedos) {
  const auto read_with = [&](const std::string& properties, const std::string& values) {
    folder_.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n" + properties +
                               "property float x\nproperty float y\nproperty float z\n"
                               "property float opacity\nproperty float scale_0\n"
                               "end_header\n" +
                               values + "0 0 0 0 -1\n");
    return read_gaussians(folder_ / "a.ply", nullptr, limits::gaussians, {.has_albedos = true})
        .at(0)
        .optics.albedo;
  };
  const std::string colors =
      "property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\n";
  EXPECT_FALSE(read_with("", "").has_value());
  EXPECT_EQ(read_with(colors, "-9 9 1e30 "), glm::dvec3(1e-6, 1.0, 1.0));
  const std::string error = error_of([&] { read_with(colors, "0 nan 0 "); });
  EXPECT_TRUE(contains(error, "vertex 0") && contains(error, "f_dc_1"));
}

// The layout that other programs read.
TEST_F(SplatFile, PlyHasTheUsualProperties) {
  Gaussian g{{1.0, 2.0, 3.0}, 1.0};
  g.set_radii(std::numbers::sqrt2 * glm::exp(glm::dvec3(-1.0, -2.0, -3.0)),
              glm::dquat(0.5, 0.5, -0.5, 0.5));
  g.density = std::log(4.0) * std::numbers::inv_sqrtpi / g.mean_radius();  // opacity 3/4
  Gaussian colored = g;
  colored.optics.albedo = glm::dvec3(1.0, 0.21404114048223255, 1e-6);
  write_splats(folder_ / "a.ply", std::vector{g, colored}, {.albedo = glm::dvec3(1.0)});
  const std::string bytes = content_of(folder_ / "a.ply");
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\n"
      "property float opacity\nproperty float scale_0\nproperty float scale_1\n"
      "property float scale_2\nproperty float rot_0\nproperty float rot_1\n"
      "property float rot_2\nproperty float rot_3\nend_header\n";
  ASSERT_TRUE(bytes.starts_with(header));
  std::array<float, 34> values{};
  ASSERT_EQ(bytes.size(), header.size() + sizeof values);
  std::memcpy(values.data(), bytes.data() + header.size(), sizeof values);
  const double full = 0.5 / 0.28209479177387814;
  const double expected[34] = {
      1, 2, 3, 0, 0, 0, full, full, full,         0, -1, -2, -3, 0.5, 0.5, -0.5, 0.5,
      1, 2, 3, 0, 0, 0, full, 0.0,  -full + 5e-5, 0, -1, -2, -3, 0.5, 0.5, -0.5, 0.5};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_opacity = i % 17 == 9;
    EXPECT_NEAR(values[i], is_opacity ? std::log(3.0) : expected[i], is_opacity ? 1e-6 : 2e-5) << i;
  }
}

TEST_F(SplatFile, PlyKeepsExtremes) {
  std::vector<Gaussian> gaussians{{{1e12, -1e12, 0.0}, 9e11, 9e11},
                                  {{0.0, 0.0, 0.0}, 2e-12, 9e11},
                                  {{0.0, 0.0, 0.0}, 1.0, 1e-300},
                                  {{0.0, 0.0, 0.0}, 1.0, 0.0}};
  write_splats(folder_ / "a.ply", gaussians);
  const std::vector<Gaussian> back = read_gaussians(folder_ / "a.ply");
  ASSERT_EQ(back.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(back[i].radius / gaussians[i].radius, 1.0, 1e-5);
    EXPECT_NEAR(back[i].density, gaussians[i].density, 1e-4 * gaussians[i].density);
  }
  EXPECT_EQ(back[3].density, 0.0);
  write_splats(folder_ / "none.ply", {});
  EXPECT_TRUE(read_gaussians(folder_ / "none.ply").empty());
}

}  // namespace

}  // namespace brume
