#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "core/io/mesh/mesh_file.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

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
