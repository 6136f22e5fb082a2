#include "brume/mesh_arrays.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/scene/mesh.h"
#include "core/scene/placement.h"
#include "tests/random.h"

namespace brume {
namespace {

const MeshArrays tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             {{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {3, 2, 0}}};

TEST(MeshArrays, AreTheMesh) {
  MeshArrays arrays = tetrahedron;
  arrays.triangles.push_back(arrays.triangles.front());  // twice
  EXPECT_EQ(to_arrays(*to_mesh(arrays)), arrays);
}

TEST(MeshArrays, KeepToTheMemory) {
  const std::size_t bytes = mesh_bytes(*to_mesh(tetrahedron));
  EXPECT_TRUE(to_mesh(tetrahedron, bytes));
  EXPECT_FALSE(to_mesh(tetrahedron, bytes - 1));
  EXPECT_EQ(to_mesh({})->n_vertices(), 0u);
}

TEST(Placement, IsUndoneByItsInverse) {
  Random random(3);
  Surface surface;
  surface.translate = {3.0, -2.0, 1.0};
  surface.rotate = glm::normalize(glm::dquat(0.8, -0.6, 0.2, 0.1));
  surface.scale = 2.5;
  surface.mesh = to_mesh(tetrahedron);
  const Placement placement(surface);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 p = random.point(5.0);
    const glm::dvec3 q = random.point(5.0);
    // Roundings of numbers up to 50.
    const auto expect_near = [](const glm::dvec3& a, const glm::dvec3& b) {
      EXPECT_LT(glm::distance(a, b), 1e-13 * 50.0);
    };
    expect_near(placement.point_to_mesh(placement.point_to_world(p)), p);
    expect_near(placement.vector_to_mesh(placement.vector_to_world(p)), p);
    expect_near(placement.normal_to_mesh(placement.normal_to_world(p)), p);
    // Vectors lead from point to point; normals keep their length and right angles to them.
    expect_near(placement.point_to_world(p) - placement.point_to_world(q),
                placement.vector_to_world(p - q));
    EXPECT_NEAR(glm::length(placement.normal_to_world(p)), glm::length(p), 1e-13 * 50.0);
    EXPECT_NEAR(glm::dot(placement.normal_to_world(glm::cross(p, q)), placement.vector_to_world(p)),
                0.0, 1e-13 * 5000.0);
  }
  const std::vector<glm::dvec3> points = world_points(surface);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0], surface.translate);
  EXPECT_EQ(points[1], placement.point_to_world({1, 0, 0}));
}

}  // namespace
}  // namespace brume
