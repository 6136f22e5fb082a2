#include <gtest/gtest.h>

#include "brume/files.h"
#include "brume/mesh_arrays.h"
#include "core/io/mesh/mesh_file.h"
#include "core/math/srgb.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

std::string ply(const std::string& properties, const std::string& rows) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\n" +
         properties + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
         rows + "3 0 1 2\n";
}

void expect_near(const glm::vec4& a, const glm::vec4& b) {
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(a[k], b[k], 1e-6f) << k;
}

const float decoded_half = static_cast<float>(srgb_decoded(0.5));

TEST(MeshColors, OfPlyAreSrgb) {
  const TemporaryFolder folder;
  const auto colors = [&](const std::string& text) {
    return to_arrays(*read_mesh(folder.write("a.ply", text))).colors;
  };
  const auto bytes = colors(
      ply("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n",
          "0 0 0 255 0 128 51\n1 0 0 0 0 0 255\n0 1 0 255 255 255 0\n"));
  ASSERT_EQ(bytes.size(), 3u);
  const auto blue = static_cast<float>(srgb_decoded(128.0 / 255.0));
  expect_near(bytes[0], {1.0f, 0.0f, blue, 0.2f});
  expect_near(bytes[2], {1.0f, 1.0f, 1.0f, 0.0f});
  const auto floats = colors(ply("property float red\nproperty float green\nproperty float blue\n",
                                 "0 0 0 0.5 2 -1\n1 0 0 nan 0 0\n0 1 0 1 1 1\n"));
  ASSERT_EQ(floats.size(), 3u);
  expect_near(floats[0], {decoded_half, 1.0f, 0.0f, 1.0f});
  expect_near(floats[1], {0.0f, 0.0f, 0.0f, 1.0f});
  const auto shorts =
      colors(ply("property ushort red\nproperty ushort green\nproperty ushort blue\n",
                 "0 0 0 65535 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n"));
  expect_near(shorts.at(0), {1.0f, 0.0f, 0.0f, 1.0f});
  EXPECT_TRUE(
      colors(ply("property uchar red\nproperty uchar green\n", "0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n"))
          .empty());
}

TEST(MeshColors, OfObjFollowThePoint) {
  const TemporaryFolder folder;
  const MeshArrays mesh = to_arrays(*read_mesh(folder.write("a.obj", R"(
v 0 0 0
v 1 0 0 0.5 0 1
v 0 1 0 0 1 0
v 1 1 0.5
vt 0 0
vt 1 0
f 1/1 2/2 3/1
f 3/2 2/1 4/1
)")));
  ASSERT_EQ(mesh.colors.size(), 6u);
  expect_near(mesh.colors[mesh.triangles[0].x], glm::vec4(1.0f));
  expect_near(mesh.colors[mesh.triangles[0].y], {decoded_half, 0.0f, 1.0f, 1.0f});
  expect_near(mesh.colors[mesh.triangles[1].y], {decoded_half, 0.0f, 1.0f, 1.0f});
  expect_near(mesh.colors[mesh.triangles[1].z], glm::vec4(1.0f));
  // A weight is no color.
  EXPECT_TRUE(to_arrays(*read_mesh(folder.write("b.obj",
                                                "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\n"
                                                "f 1 2 3\n")))
                  .colors.empty());
}

TEST(MeshColors, GiveSurfacesAMaterialThatShowsThem) {
  const TemporaryFolder folder;
  const std::string rows = "0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n";
  const auto colored = folder.write(
      "a.ply", ply("property float red\nproperty float green\nproperty float blue\n", rows));
  const auto plain =
      folder.write("b.ply", ply("property float r\nproperty float g\nproperty float b\n", rows));
  EXPECT_EQ(load_surface(colored).material.type, Material::Type::metallic_roughness);
  EXPECT_EQ(load_surface(colored).material.metallic_roughness.metallic, 0.0);
  EXPECT_EQ(load_surface(plain).material.type, Material::Type::diffuse);
}

TEST(MeshTexcoords, OfObjSplitVerticesAtSeams) {
  const TemporaryFolder folder;
  // Two triangles fold along 2-3, with other coordinates on either side of it.
  const MeshArrays mesh = to_arrays(*read_mesh(folder.write("a.obj", R"(
v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0.5
vt 0 0
vt 1 0
vt 0 1
vt 0.25 0.5
f 1/1 2/2 3/3
f 3/4 2/4 4/1
)")));
  ASSERT_EQ(mesh.points.size(), 6u);
  ASSERT_EQ(mesh.texcoords.size(), 6u);
  EXPECT_EQ(mesh.texcoords[mesh.triangles[0].y], glm::vec2(1.0f, 0.0f));
  EXPECT_EQ(mesh.texcoords[mesh.triangles[1].y], glm::vec2(0.25f, 0.5f));
  // Normals that the file does not have are smooth across the seam, as without coordinates.
  EXPECT_EQ(mesh.normals[mesh.triangles[0].y], mesh.normals[mesh.triangles[1].y]);
}

TEST(MeshTexcoords, OfObjMayBeMissingOrWrong) {
  const TemporaryFolder folder;
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_TRUE(
      to_arrays(*read_mesh(folder.write("a.obj", points + "f 1/1 2/2 3/3\n"))).texcoords.empty());
  const MeshArrays mesh = to_arrays(*read_mesh(
      folder.write("b.obj", points + "vt nan 1\nvt 0.5 1e300\nvt 0.5\nf 1/1 2/2 3/3\n")));
  EXPECT_EQ(mesh.texcoords, (std::vector<glm::vec2>{{0, 0}, {0, 0}, {0.5f, 0}}));
}

TEST(MeshTexcoords, OfPlyAreRead) {
  const TemporaryFolder folder;
  for (const auto& [u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
    const MeshArrays mesh = to_arrays(*read_mesh(folder.write(
        "a.ply", std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nproperty float ") +
                     u + "\nproperty float " + v +
                     "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                     "0 0 0 0 0.5\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n")));
    EXPECT_EQ(mesh.texcoords, (std::vector<glm::vec2>{{0, 0.5f}, {1, 0}, {0, 1}})) << u;
  }
}

}  // namespace

}  // namespace brume
