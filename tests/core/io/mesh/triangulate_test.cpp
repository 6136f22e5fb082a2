#include "core/io/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "brume/mesh_arrays.h"
#include "core/io/mesh/mesh_file.h"
#include "core/math/normals.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/random.h"

namespace brume {
namespace {

using Points = std::vector<glm::dvec3>;
using Corners = std::vector<std::uint32_t>;

double area_of(const auto& points, const std::vector<glm::uvec3>& triangles) {
  double area = 0.0;
  for (const glm::uvec3& t : triangles) area += 0.5 * glm::length(area_normal(points, t));
  return area;
}

double triangulated_area(const Points& points, const Corners& corners) {
  RawMesh mesh;
  mesh.points = points;
  add_polygon(mesh, corners);
  const Triangulation faces = triangulate(mesh);
  EXPECT_EQ(faces.polygons, std::vector<std::uint32_t>(faces.triangles.size(), 0));
  return area_of(points, faces.triangles);
}

Corners all_of(const Points& points) {
  Corners corners(points.size());
  std::iota(corners.begin(), corners.end(), 0u);
  return corners;
}

// By the shoelace formula, of a polygon in the plane of x and y.
double polygon_area(const Points& points, const Corners& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& a = points[corners[i]];
    const glm::dvec3& b = points[corners[(i + 1) % corners.size()]];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return std::abs(area);
}

// Whichever corner is the first, either way round, in any plane.
void expect_covered(const Points& points, Corners corners) {
  const double area = polygon_area(points, corners);
  Points tilted;
  for (const glm::dvec3& p : points) {
    tilted.emplace_back(0.6 * p.x - 0.64 * p.y + 3.0, 0.8 * p.x + 0.48 * p.y, 0.6 * p.y - 1.0);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_NEAR(triangulated_area(points, corners), area, 1e-9 * area) << "first " << i;
    EXPECT_NEAR(triangulated_area(tilted, corners), area, 1e-9 * area) << "first " << i;
    std::ranges::reverse(corners);
    EXPECT_NEAR(triangulated_area(points, corners), area, 1e-9 * area) << "first " << i;
    std::ranges::reverse(corners);
    std::ranges::rotate(corners, corners.begin() + 1);
  }
}

TEST(Triangulate, CoversConcavePolygons) {
  const Points l{{2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}};
  expect_covered(l, all_of(l));
  const Points arrow{{0, 0, 0}, {2, -2, 0}, {0, 3, 0}, {-2, -2, 0}};
  expect_covered(arrow, all_of(arrow));
  const Points comb{{0, 0, 0}, {7, 0, 0}, {7, 3, 0}, {6, 3, 0}, {6, 1, 0}, {5, 1, 0}, {5, 3, 0},
                    {4, 3, 0}, {4, 1, 0}, {3, 1, 0}, {3, 3, 0}, {0, 3, 0}, {2, 1, 0}};
  expect_covered(comb, all_of(comb));
}

TEST(Triangulate, CoversRandomStarsAndStreets) {
  Random random(1);
  for (int k = 0; k < 50; ++k) {
    Points star;
    const int count = 5 + k % 20;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + random.uniform(0.0, 0.9)) / count;
      const double radius = random.uniform(0.1, 1.0);
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    expect_covered(star, all_of(star));
    // Houses along both sides of a line; without houses on either side, only the line is left.
    Points street;
    const int houses = 2 + k % 5;
    const auto add_side = [&](int begin, int step, double sign) {
      for (int i = begin; i >= 0 && i < houses; i += step) {
        const double depth = sign * std::floor(random.uniform(0.0, 3.0));
        street.emplace_back(step > 0 ? i : i + 1, depth, 0.0);
        street.emplace_back(step > 0 ? i + 1 : i, depth, 0.0);
      }
    };
    add_side(0, 1, 1.0);
    add_side(houses - 1, -1, -1.0);
    expect_covered(street, all_of(street));
  }
}

TEST(Triangulate, LeavesHolesThatAreJoinedToTheOutline) {
  const Points square_in_square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}};
  expect_covered(square_in_square, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
}

TEST(Triangulate, CoversOutlinesWithIdleCorners) {
  const Points on_edges{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},  {2, 2, 0},
                        {1, 2, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0.5, 0}};
  expect_covered(on_edges, all_of(on_edges));
  const Points twice{{0, 0, 0}, {0, 0, 0}, {2, 0, 0},   {2, 2, 0},
                     {2, 2, 0}, {2, 2, 0}, {1, 0.5, 0}, {0, 2, 0}};
  expect_covered(twice, all_of(twice));
  const Points with_spike{{0, 0, 0}, {2, 0, 0},   {3, 0, 0}, {2, 0, 0},
                          {2, 1, 0}, {1, 0.5, 0}, {0, 1, 0}};
  expect_covered(with_spike, all_of(with_spike));
}

TEST(Triangulate, KeepsTheFanOfConvexPolygons) {
  RawMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0.1}, {2, 1, 0}, {1, 2, -0.1}, {0, 1, 0}};  // not quite flat
  add_polygon(mesh, Corners{1, 2, 3, 4, 0});
  EXPECT_EQ(triangulate(mesh).triangles,
            (std::vector<glm::uvec3>{{1, 2, 3}, {1, 3, 4}, {1, 4, 0}}));
}

TEST(Triangulate, CutsBentPolygonsInTheirMeanPlane) {
  const Points l{{2, 0, 0.2}, {2, 1, 0}, {1, 1, 0.1}, {1, 2, 0}, {0, 2, 0.2}, {0, 0, 0}};
  const double area = triangulated_area(l, all_of(l));
  EXPECT_GT(area, 3.0);
  EXPECT_LT(area, 3.2);
}

TEST(Triangulate, SurvivesWhatIsNoPolygon) {
  RawMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}};
  for (const Corners& corners :
       {Corners{0, 1, 2, 3}, Corners{0, 1, 4, 2, 3, 0, 4}, Corners{0, 0, 0, 0}, Corners{0, 1, 0, 1},
        Corners{0, 1}, Corners{4, 0, 3, 1, 4, 2}}) {
    add_polygon(mesh, corners);
  }
  for (const glm::uvec3& t : triangulate(mesh).triangles) {
    EXPECT_TRUE(t.x != t.y && t.y != t.z && t.z != t.x);
  }
  Random random(2);
  Points scribble;
  for (int i = 0; i < 300; ++i) {
    scribble.emplace_back(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), 0.0);
  }
  EXPECT_GT(triangulated_area(scribble, all_of(scribble)), 0.0);
}

// Looking at all other corners for each would take hours.
TEST(Triangulate, CoversPolygonsOfAHundredThousandCorners) {
  Points gear;
  Points comb{{0, -1, 0}};
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const double radius = i % 2 == 0 ? 1.0 : 0.99;
    gear.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    comb.emplace_back(i, i % 2, 0.0);
  }
  comb.emplace_back(count, -1, 0);
  for (const Points& points : {gear, comb}) {
    const double area = polygon_area(points, all_of(points));
    EXPECT_NEAR(triangulated_area(points, all_of(points)), area, 1e-8 * area);
  }
}

TEST(Triangulate, IsWhatEveryFormatHas) {
  const TemporaryFolder folder;
  const std::string points = "2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n";
  std::string vertices = "v " + points;
  for (std::size_t end = vertices.find('\n'); end + 1 < vertices.size();
       end = vertices.find('\n', end + 1)) {
    vertices.insert(end + 1, "v ");
  }
  const std::pair<const char*, std::string> files[] = {
      {"l.obj", "f 1 2 3 4 5 6\n" + vertices},
      {"l.off", "OFF\n6 1 0\n" + points + "6 0 1 2 3 4 5\n"},
      {"l.ply",
       "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
       "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
           points + "6 0 1 2 3 4 5\n"}};
  for (const auto& [name, content] : files) {
    const MeshArrays mesh = to_arrays(*read_mesh(folder.write(name, content)));
    EXPECT_NEAR(area_of(mesh.points, mesh.triangles), 3.0, 1e-6) << name;
  }
}

}  // namespace
}  // namespace brume
