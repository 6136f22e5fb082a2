#include "brume/primitive.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "brume/mesh_arrays.h"
#include "core/scene/mesh.h"
#include "core/scene/placement.h"
#include "tests/random.h"

namespace brume {
namespace {

using enum Primitive::Shape;

MeshArrays arrays_of(const Primitive& primitive) {
  return to_arrays(*mesh_of(primitive));
}

glm::dvec3 corner(const MeshArrays& mesh, unsigned i) {
  return glm::dvec3(mesh.points[i]);
}

// By the divergence theorem: what triangles enclose that face outwards.
double volume(const MeshArrays& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    sum += glm::dot(corner(mesh, t.x), glm::cross(corner(mesh, t.y), corner(mesh, t.z))) / 6.0;
  }
  return sum;
}

// Triangles and normals agree on where the outside is.
void expect_normals_of_triangles(const MeshArrays& mesh, double min_cosine) {
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = corner(mesh, t.x);
    const glm::dvec3 face =
        glm::normalize(glm::cross(corner(mesh, t.y) - a, corner(mesh, t.z) - a));
    for (const unsigned i : {t.x, t.y, t.z}) {
      EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0, 1e-5);
      EXPECT_GT(glm::dot(face, glm::dvec3(mesh.normals[i])), min_cosine);
    }
  }
}

TEST(Primitive, PlaneFacesUp) {
  const MeshArrays mesh = arrays_of({plane, {4.0, 9.0, 2.0}});
  double area = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = corner(mesh, t.x);
    area += glm::cross(corner(mesh, t.y) - a, corner(mesh, t.z) - a).y / 2.0;
    EXPECT_EQ(a.y, 0.0);
  }
  EXPECT_NEAR(area, 8.0, 1e-5);
  expect_normals_of_triangles(mesh, 0.999);
}

TEST(Primitive, ShapesEncloseTheirVolume) {
  const glm::dvec3 size(1.0, 2.0, 3.0);
  EXPECT_NEAR(volume(arrays_of({box, size})), 6.0, 1e-5);
  const double ball = glm::pi<double>();  // 4/3 pi (1/2) 1 (3/2)
  EXPECT_NEAR(volume(arrays_of({sphere, size})), ball, 0.01 * ball);
  const double drum = 1.5 * glm::pi<double>();  // pi (1/2) (3/2) * 2
  EXPECT_NEAR(volume(arrays_of({cylinder, size})), drum, 0.01 * drum);
}

TEST(Primitive, NormalsPointOutwards) {
  const glm::dvec3 size(1.0, 1.5, 2.0);
  expect_normals_of_triangles(arrays_of({box, size}), 0.999);
  expect_normals_of_triangles(arrays_of({sphere, size}), 0.97);
  expect_normals_of_triangles(arrays_of({cylinder, size}), 0.97);
}

TEST(Primitive, ExtremeSizesStayFinite) {
  for (const Primitive::Shape shape : {plane, box, sphere, cylinder}) {
    const MeshArrays mesh = arrays_of({shape, {1e12, 1e-12, 1.0}});
    for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-4f);
  }
}

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
    expect_near(placement.normal_to_mesh(placement.normal_to_world(p)), p);
    // Vectors lead from point to point; normals keep their length and right angles to them.
    const glm::dvec3 v = placement.point_to_world(p) - placement.point_to_world(q);
    expect_near(placement.vector_to_mesh(v), p - q);
    EXPECT_NEAR(glm::length(placement.normal_to_world(p)), glm::length(p), 1e-13 * 50.0);
    EXPECT_NEAR(glm::dot(placement.normal_to_world(glm::cross(p, q)), v), 0.0, 1e-13 * 5000.0);
  }
  const std::vector<glm::dvec3> points = world_points(surface);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0], surface.translate);
  EXPECT_EQ(points[1], placement.point_to_world({1, 0, 0}));
}

}  // namespace

}  // namespace brume
