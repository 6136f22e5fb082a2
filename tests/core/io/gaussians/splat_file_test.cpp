// Gaussians written as splats, and read back.

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

#include "core/io/gaussians/gaussian_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/gaussians/random_ellipsoids.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

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
