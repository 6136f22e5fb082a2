#include "brume/primitive.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "brume/mesh_arrays.h"

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

}  // namespace
}  // namespace brume
