#include "core/scene/copies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "brume/error.h"
#include "brume/limits.h"
#include "brume/primitive.h"
#include "core/scene/placement.h"

namespace brume {
namespace {

// 6 u x 2 u, tilted.
Surface slope() {
  Surface surface;
  surface.name = "slope";
  surface.primitive = Primitive{Primitive::Shape::plane, {3.0, 1.0, 1.0}};
  surface.mesh = mesh_of(*surface.primitive);
  surface.translate = {1.0, 2.0, 3.0};
  surface.rotate = glm::angleAxis(0.5, glm::normalize(glm::dvec3(1.0, 0.0, 1.0)));
  surface.scale = 2.0;
  return surface;
}

const Scatter scatter{
    .over = "slope", .density = 50.0, .seed = 4, .scale = {0.5, 1.5}, .max_turn = 30.0};

TEST(Scatter, IsTheSameForTheSameSeed) {
  EXPECT_EQ(scattered(scatter, slope()), scattered(scatter, slope()));
  Scatter other = scatter;
  ++other.seed;
  EXPECT_NE(scattered(other, slope()), scattered(scatter, slope()));
}

TEST(Scatter, IsUniformByArea) {
  const CopyPlacements copies = scattered(scatter, slope());
  ASSERT_EQ(copies.size(), 600u) << "12 u^2";
  int right = 0, front = 0;
  for (const CopyPlacement& copy : copies) {
    const glm::dvec3 place = Placement(slope()).point_to_mesh(copy.translate);
    EXPECT_NEAR(place.y, 0.0, 1e-9);
    EXPECT_LE(std::abs(place.x), 1.5 + 1e-9);
    EXPECT_LE(std::abs(place.z), 0.5 + 1e-9);
    right += place.x > 0.0;
    front += place.z > 0.0;
  }
  EXPECT_NEAR(right, 300, 62) << "five deviations";
  EXPECT_NEAR(front, 300, 62);
}

TEST(Scatter, StandsOnTheNormalScaledAndTurned) {
  const glm::dvec3 normal = slope().rotate * glm::dvec3(0.0, 1.0, 0.0);
  const glm::dquat upright = scattered({.over = "slope"}, slope()).front().rotate;
  EXPECT_LT(glm::distance(upright * glm::dvec3(0.0, 1.0, 0.0), normal), 1e-6);
  double least = 10.0, greatest = 0.0, turned = 0.0;
  for (const CopyPlacement& copy : scattered(scatter, slope())) {
    EXPECT_LT(glm::distance(copy.rotate * glm::dvec3(0.0, 1.0, 0.0), normal), 1e-6);
    least = std::min(least, copy.scale);
    greatest = std::max(greatest, copy.scale);
    const double cosine =
        glm::dot(copy.rotate * glm::dvec3(1.0, 0.0, 0.0), upright * glm::dvec3(1.0, 0.0, 0.0));
    turned = std::max(turned, std::acos(std::min(cosine, 1.0)));
  }
  EXPECT_GE(least, 0.5);
  EXPECT_LT(least, 0.52);
  EXPECT_LE(greatest, 1.5);
  EXPECT_GT(greatest, 1.48);
  EXPECT_NEAR(turned, glm::radians(30.0), glm::radians(1.0));
}

TEST(Copies, OfAllSurfacesAreLimited) {
  Scene scene;
  scene.surfaces = {slope(), slope(), slope()};
  for (std::size_t i = 1; i < 3; ++i) {
    scene.surfaces[i].name = "tree";
    scene.surfaces[i].copies = Copies{.scatter = scatter};
    const double area = scattered_count(scatter, slope()) / scatter.density;
    scene.surfaces[i].copies->scatter.density = 0.6 * static_cast<double>(limits::copies) / area;
  }
  EXPECT_THROW(check(scene), DomainError);
  scene.surfaces.pop_back();
  EXPECT_NO_THROW(check(scene));
}

TEST(Copies, ArePlacedAsTheirSurfaceIsTurnedAndScaled) {
  Surface tree;
  tree.primitive = Primitive{Primitive::Shape::box, {1.0, 2.0, 3.0}};
  tree.mesh = mesh_of(*tree.primitive);
  tree.translate = {9.0, 9.0, 9.0};
  tree.rotate = glm::angleAxis(0.3, glm::dvec3(0.0, 1.0, 0.0));
  tree.scale = 2.0;
  const CopyPlacement copy{{1.0, 2.0, 3.0}, glm::angleAxis(0.7, glm::dvec3(1.0, 0.0, 0.0)), 3.0};
  tree.copies = Copies{.placements = std::make_shared<const CopyPlacements>(1, copy)};
  const std::vector<Surface> placed = with_placed_copies({tree, slope()});
  EXPECT_FALSE(placed[0].copies);
  ASSERT_EQ(placement_count(placed[0]), 2u);
  EXPECT_EQ(placement_of(placed[0], 0), Placement(tree));
  const glm::dvec3 p(0.1, 0.2, 0.3);
  const glm::dvec3 wanted =
      copy.translate + copy.rotate * (copy.scale * (tree.rotate * (tree.scale * p)));
  EXPECT_LT(glm::distance(placement_of(placed[0], 1).point_to_world(p), wanted), 1e-12);
  // A frame is the same object until something changes, and stays as it is.
  EXPECT_EQ(with_placed_copies({tree})[0].placed_copies, placed[0].placed_copies);
  EXPECT_EQ(with_placed_copies(placed), placed);

  tree.copies = Copies{.scatter = scatter};
  EXPECT_EQ(with_placed_copies({tree, slope()})[0].placed_copies->size(), 600u);
  EXPECT_EQ(with_placed_copies({tree})[0].placed_copies, nullptr) << "over nothing";
}

TEST(WorldBox, IsThatOfEveryVertexOfCopies) {
  Surface ball;
  ball.primitive = Primitive{Primitive::Shape::sphere, {1.0, 2.0, 1.0}};
  ball.mesh = mesh_of(*ball.primitive);
  Scatter wild = scatter;
  wild.density = 5.0;
  ball.copies = Copies{.scatter = wild};
  const Surface placed = with_placed_copies({ball, slope()})[0];
  glm::dvec3 low(1e9), high(-1e9);
  double farthest = 0.0;
  for (std::size_t copy = 0; copy < placement_count(placed); ++copy) {
    for (const glm::vec3& p : to_arrays(*ball.mesh).points) {
      const glm::dvec3 q = placement_of(placed, copy).point_to_world(glm::dvec3(p));
      low = glm::min(low, q);
      high = glm::max(high, q);
      farthest = std::max(farthest, glm::distance(q, glm::dvec3(1.0, 2.0, 3.0)));
    }
  }
  ASSERT_EQ(placement_count(placed), 61u);
  EXPECT_EQ(world_box(placed).low, low);
  EXPECT_EQ(world_box(placed).high, high);
  EXPECT_EQ(farthest_vertex(placed, {1.0, 2.0, 3.0}), farthest);
}

}  // namespace
}  // namespace brume
