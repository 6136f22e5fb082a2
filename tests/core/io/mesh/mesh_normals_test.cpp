// Normals of meshes that have none in their file.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "core/io/mesh/mesh_file.h"
#include "core/io/mesh/places.h"
#include "core/math/normals.h"
#include "tests/core/io/folder_test.h"
#include "tests/random.h"

namespace brume {
namespace {

using Faces = std::vector<std::vector<int>>;  // from 1, as of OBJ

class MeshNormals : public FolderTest {
 protected:
  MeshArrays read(const std::string& points, const Faces& faces) {
    std::string text = points;
    for (const std::vector<int>& face : faces) {
      text += "f";
      for (const int corner : face) (text += ' ') += std::to_string(corner);
      text += "\n";
    }
    return to_arrays(*read_mesh(folder_.write("a.obj", text)));
  }
};

Faces turned(Faces faces) {
  for (std::vector<int>& face : faces) std::ranges::reverse(face);
  return faces;
}

Faces operator+(Faces a, const Faces& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Two bent quads.
const std::string sheet_points =
    "v -1 -0.5 0\nv -1 0.5 0\nv 0 -0.5 0.2\nv 0 0.5 0.2\nv 1 -0.5 0\nv 1 0.5 0\n";
const Faces sheet{{1, 3, 4, 2}, {3, 5, 6, 4}};

// A ridge of eight triangles, sharper than a right angle.
const std::string ridge_points =
    "v -1 -1 0\nv -1 1 0\nv 0 -1 2\nv 0 1 2\nv 1 -1 0\nv 1 1 0\nv -0.5 0 1\nv 0.5 0 1\n";
const Faces ridge{{1, 3, 7}, {3, 4, 7}, {4, 2, 7}, {2, 1, 7},
                  {3, 5, 8}, {5, 6, 8}, {6, 4, 8}, {4, 3, 8}};

// Corner by corner the same triangles with the same normals, all perhaps turned round.
void expect_same_sheet(const MeshArrays& a, const MeshArrays& b, std::size_t first_triangle = 0) {
  ASSERT_LE(first_triangle + b.triangles.size(), a.triangles.size());
  for (std::size_t t = 0; t < b.triangles.size(); ++t) {
    const glm::uvec3& triangle = a.triangles[first_triangle + t];
    double side = 0.0;
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& point = b.points[b.triangles[t][k]];
      int same = 0;
      while (same < 3 && a.points[triangle[same]] != point) ++same;
      ASSERT_LT(same, 3) << "triangle " << t;
      const double cosine =
          glm::dot(glm::dvec3(a.normals[triangle[same]]), glm::dvec3(b.normals[b.triangles[t][k]]));
      EXPECT_NEAR(std::abs(cosine), 1.0, 1e-6) << "triangle " << t;
      EXPECT_GE(cosine * side, 0.0) << "triangle " << t;
      side = cosine;
    }
  }
}

TEST_F(MeshNormals, OfDoubledSheetsAreThoseOfOne) {
  const MeshArrays one = read(sheet_points, sheet);
  for (const Faces& back : {turned(sheet), Faces{{3, 1, 2, 4}, {6, 4, 3, 5}}, sheet}) {
    const MeshArrays both = read(sheet_points, sheet + back);
    EXPECT_EQ(both.triangles.size(), 8u);
    expect_same_sheet(both, one);
    expect_same_sheet(both, one, 4);
  }
}

TEST_F(MeshNormals, OfASheetWithABackOfItsOwnAreThoseOfOne) {
  const MeshArrays one = read(sheet_points, sheet);
  const MeshArrays both =
      read(sheet_points + sheet_points, sheet + Faces{{8, 10, 9, 7}, {10, 12, 11, 9}});
  expect_same_sheet(both, one);
  expect_same_sheet(both, one, 4);
}

TEST_F(MeshNormals, OfTriangulatedDoubledSheetsPointToOneSide) {
  // The back is cut along the other diagonals.
  const MeshArrays both = read(
      sheet_points,
      {{1, 3, 4}, {1, 4, 2}, {3, 5, 6}, {3, 6, 4}, {2, 4, 3}, {2, 3, 1}, {4, 6, 5}, {4, 5, 3}});
  for (const glm::vec3& normal : both.normals) EXPECT_GT(normal.z, 0.9f);
}

TEST_F(MeshNormals, DoNotDependOnHowEachTriangleIsWound) {
  const MeshArrays alike = read(ridge_points, ridge);
  for (unsigned pattern = 1; pattern < 255; ++pattern) {
    Faces mixed = ridge;
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      if ((pattern >> i & 1u) != 0) std::swap(mixed[i][1], mixed[i][2]);
    }
    expect_same_sheet(read(ridge_points, mixed), alike);
  }
}

TEST_F(MeshNormals, KeepTheWindingOfMostTriangles) {
  Faces mixed = ridge;
  std::swap(mixed[2][0], mixed[2][1]);
  std::swap(mixed[5][0], mixed[5][1]);
  for (const Faces& faces : {mixed, turned(mixed)}) {
    const MeshArrays mesh = read(ridge_points, faces);
    const glm::dvec3 first = area_normal(mesh.points, mesh.triangles[0]);
    const bool is_outward = first.x < 0.0;
    EXPECT_EQ(is_outward, faces == mixed);
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 normal = area_normal(mesh.points, t);
      EXPECT_EQ(normal.z > 0.0, is_outward);
      EXPECT_GT(glm::dot(normal, glm::dvec3(mesh.normals[t.x])), 0.0);
    }
  }
}

TEST_F(MeshNormals, SmoothSeamsBetweenPatchesThatAreWoundDifferently) {
  const std::string points =
      "v -1 -1 0\nv -1 1 0\nv 0 -1 0.3\nv 0 1 0.3\nv 0 -1 0.3\nv 0 1 0.3\nv 1 -1 0\nv 1 1 0\n";
  const Faces left{{1, 3, 4}, {1, 4, 2}};
  const Faces right{{5, 7, 8}, {5, 8, 6}};
  expect_same_sheet(read(points, left + Faces{{5, 8, 7}, {5, 6, 8}}), read(points, left + right));
}

TEST_F(MeshNormals, AreOnBothSidesOfAMoebiusStrip) {
  constexpr int count = 24;
  std::string points;
  Faces faces;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / count;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1.0 + side * std::cos(0.5 * angle);
      points += "v " + std::to_string(radius * std::cos(angle)) + " " +
                std::to_string(side * std::sin(0.5 * angle)) + " " +
                std::to_string(radius * std::sin(angle)) + "\n";
    }
    const int a = 2 * i + 1;
    const int b = i + 1 < count ? a + 2 : 2;
    const int c = i + 1 < count ? a + 3 : 1;
    faces.push_back({a, b, c});
    faces.push_back({a, c, a + 1});
  }
  const MeshArrays strip = read(points, faces);
  ASSERT_EQ(strip.triangles.size(), 2u * count);
  for (const glm::vec3& normal : strip.normals) {
    const float length = glm::length(normal);
    EXPECT_TRUE(length == 0.0f || std::abs(length - 1.0f) < 1e-6f);
  }
}

TEST_F(MeshNormals, AreZeroWhereTrianglesCancel) {
  // Two triangles that touch in one corner, wound differently.
  const MeshArrays mesh =
      read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n", {{1, 2, 3}, {1, 5, 4}});
  EXPECT_EQ(mesh.normals,
            (std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, -1}}));
}

TEST_F(MeshNormals, AreComputedWhereTheFileHasOnlyZeros) {
  const MeshArrays one = read(sheet_points, sheet);
  const std::string zeros = sheet_points + "vn 0 0 0\n";
  const MeshArrays both = to_arrays(*read_mesh(folder_.write(
      "b.obj", zeros + "f 1//1 3//1 4//1 2//1\nf 3//1 5//1 6//1 4//1\nf 2//1 4//1 3//1 1//1\n"
                       "f 4//1 6//1 5//1 3//1\n")));
  expect_same_sheet(both, one);
}

// Vertices at one place, and polygons that are there once more, against looking at all pairs.

using Index = std::uint32_t;

RawMesh random_mesh(Random& random) {
  const auto one_of = [&](int count) { return static_cast<int>(random.uniform(0.0, count)); };
  RawMesh mesh;
  const int places = 2 + one_of(4);
  const double signed_zero = -0.0;
  for (int i = 0; i < 30; ++i) {
    const double y = one_of(2) == 0 ? 0.0 : signed_zero;
    mesh.points.emplace_back(one_of(places), y, one_of(2));
  }
  for (int i = 0; i < 60; ++i) {
    std::vector<Index> corners(static_cast<std::size_t>(3 + one_of(2)));
    for (Index& corner : corners) corner = static_cast<Index>(one_of(30));
    add_polygon(mesh, corners);
  }
  return mesh;
}

TEST(Places, AreTheFirstPointsThere) {
  Random random(1);
  for (unsigned n = 0; n < random_cases(30); ++n) {
    const RawMesh mesh = random_mesh(random);
    const std::vector<Index> places = find_places(mesh.points);
    for (Index i = 0; i < mesh.points.size(); ++i) {
      const auto first = std::ranges::find(mesh.points, mesh.points[i]) - mesh.points.begin();
      ASSERT_EQ(places[i], static_cast<Index>(first));
    }
  }
}

// Whether b is a, begun at another corner, turned round or not.
bool are_alike(const std::vector<Index>& a, std::vector<Index> b) {
  if (a.size() != b.size()) return false;
  for (int side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (a == b) return true;
      std::ranges::rotate(b, b.begin() + 1);
    }
    std::ranges::reverse(b);
  }
  return false;
}

TEST(PolygonCopies, AreThoseOfTheFirstAlike) {
  Random random(2);
  std::size_t copy_count = 0;
  for (unsigned n = 0; n < random_cases(30); ++n) {
    const RawMesh mesh = random_mesh(random);
    const std::vector<Index> places = find_places(mesh.points);
    std::vector<std::vector<Index>> polygons;
    for (std::size_t begin = 0; const std::size_t end : mesh.polygon_ends) {
      std::vector<Index>& own = polygons.emplace_back();
      for (; begin < end; ++begin) own.push_back(places[mesh.corners[begin]]);
    }
    const PolygonCopies copies = find_copies(mesh, places);
    for (Index i = 0; i < polygons.size(); ++i) {
      std::vector<Index> different = polygons[i];
      std::ranges::sort(different);
      // The lowest place of one that passes it twice is no single start.
      if (std::ranges::adjacent_find(different) != different.end()) continue;
      const auto first = std::ranges::find_if(
          polygons, [&](const std::vector<Index>& other) { return are_alike(polygons[i], other); });
      ASSERT_EQ(copies.originals[i], static_cast<Index>(first - polygons.begin()));
      copy_count += copies.is_copy(i) ? 1 : 0;
    }
  }
  EXPECT_GT(copy_count, 0u);
}

}  // namespace

}  // namespace brume
