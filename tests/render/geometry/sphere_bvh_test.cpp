#include "render/geometry/sphere_bvh.h"
#include "core/scene/camera_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/geometry/tiles.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

struct Spheres {
  std::vector<glm::dvec3> centers;
  std::vector<double> radii;
};

Spheres random_spheres(Random& random, int count) {
  Spheres s;
  for (int i = 0; i < count; ++i) {
    s.centers.push_back(random.point(5.0));
    s.radii.push_back(i % 7 == 0 ? 0.0 : random.uniform(0.01, 0.5));
  }
  return s;
}

template <class Shape>
std::vector<std::uint32_t> found(const SphereBvh& bvh, const Shape& shape) {
  std::vector<std::uint32_t> indices;
  bvh.query(shape, [&](std::uint32_t i) { indices.push_back(i); });
  std::sort(indices.begin(), indices.end());
  return indices;
}

// Every sphere that the shape touches, and each once.
template <class Shape>
std::vector<std::uint32_t> by_loop(const Spheres& s, const Shape& shape) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < s.centers.size(); ++i) {
    if (s.radii[i] > 0.0 && shape.touches(s.centers[i], s.radii[i])) indices.push_back(i);
  }
  return indices;
}

TEST(SphereBvh, MatchesBruteForce) {
  Random random(3);
  for (const int count : {0, 1, 4, 5, 100, 3000}) {
    const Spheres s = random_spheres(random, count);
    const SphereBvh bvh(s.centers, s.radii);
    for (int k = 0; k < 50; ++k) {
      const RaySegment ray{random.point(6.0), glm::normalize(random.point(1.0)),
                           k % 3 == 0 ? INFINITY : random.uniform(0.0, 10.0)};
      ASSERT_EQ(found(bvh, ray), by_loop(s, ray));
      const TriangleShape triangle{random.point(6.0), random.point(6.0), random.point(6.0)};
      ASSERT_EQ(found(bvh, triangle), by_loop(s, triangle));
      const glm::dvec3 end = random.point(5.0);
      const std::vector<glm::dvec3> ends{end, end + random.point(0.3), end + random.point(0.3)};
      const RayBundle bundle(random.point(6.0), ends);
      ASSERT_EQ(found(bvh, bundle), by_loop(s, bundle));
    }
  }
}

// touches() of a bundle holds for every sphere that one of its segments touches.
TEST(RayBundle, MissesNothingThatItsSegmentsTouch) {
  Random random(4);
  int touched = 0;
  for (int k = 0; k < 100000; ++k) {
    const glm::dvec3 origin = random.point(2.0);
    const double spread = std::pow(10.0, random.uniform(-6.0, 0.5));
    const glm::dvec3 target = random.point(3.0);
    std::vector<glm::dvec3> ends;
    for (int i = 0; i < 4; ++i) ends.push_back(target + random.point(spread));
    const RayBundle bundle(origin, ends);
    const glm::dvec3 center = random.point(3.0);
    const double radius = std::pow(10.0, random.uniform(-3.0, 0.0));
    for (const glm::dvec3& end : ends) {
      const double length = glm::length(end - origin);
      if (!RaySegment{origin, (end - origin) / length, length}.touches(center, radius)) continue;
      ++touched;
      ASSERT_TRUE(bundle.touches(center, radius));
    }
  }
  EXPECT_GT(touched, 1000);
}

// The distance of a triangle from a point by dense sampling is never below the radius at which
// touches() turns true.
TEST(TriangleShape, AgreesWithSampling) {
  Random random(5);
  for (int k = 0; k < 300; ++k) {
    const TriangleShape triangle{random.point(1.0), random.point(1.0), random.point(1.0)};
    const glm::dvec3 center = random.point(2.0);
    double min_distance = INFINITY;
    for (int i = 0; i <= 200; ++i) {
      for (int j = 0; i + j <= 200; ++j) {
        const glm::dvec3 p = triangle.a + i / 200.0 * (triangle.b - triangle.a) +
                             j / 200.0 * (triangle.c - triangle.a);
        min_distance = std::min(min_distance, glm::length(p - center));
      }
    }
    EXPECT_TRUE(triangle.touches(center, min_distance + 1e-9));
    EXPECT_FALSE(triangle.touches(center, min_distance - 0.03));
  }
}

// The tile lists hold every Gaussian that a pixel's ray comes near to, eye inside and behind
// included.
TEST(Tiles, ListsMissNothing) {
  Random random(6);
  for (int round = 0; round < 10; ++round) {
    Medium medium;
    for (int i = 0; i < 60; ++i) {
      medium.append({random.point(4.0), random.uniform(0.05, 0.4), random.uniform(0.0, 5.0)});
    }
    const MediumIndex index(medium, 1e-4);
    const Film film{101, 67};
    const CameraRays rays(
        {random.point(4.0), random.point(1.0), {0, 1, 0}, random.uniform(10, 120)}, film);
    const Tiles tiles(film);
    const Tiles::Lists lists = tiles.lists(index, rays);
    int near = 0;
    for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
      const auto list = lists.gaussians_of(tile);
      const auto r = tiles.rectangle(tile);
      for (int y = r.y0; y < r.y1; ++y) {
        for (int x = r.x0; x < r.x1; ++x) {
          const RaySegment ray{rays.eye(), rays.direction(x + 0.5, y + 0.5), INFINITY};
          for (std::uint32_t i = 0; i < index.size(); ++i) {
            if (!(index.cutoff_radii()[i] > 0) ||
                !ray.touches(index.gaussians()[i].b, index.cutoff_radii()[i])) {
              continue;
            }
            ++near;
            ASSERT_TRUE(std::find(list.begin(), list.end(), i) != list.end())
                << "pixel " << x << " " << y << " Gaussian " << i;
          }
        }
      }
    }
    EXPECT_GT(near, 100);
  }
}

// Where lists would fill the memory, all tiles share one.
TEST(Tiles, ManyGaussiansThatFillTheViewShareAList) {
  Medium medium;
  for (int i = 0; i < 50; ++i) medium.append({{0, 0, 0}, 10.0, 1.0});
  medium.append({{0, 0, 1000}, 1.0, 1.0});  // behind the eye
  const MediumIndex index(medium, 1e-4);
  const Film film{256, 128};
  const CameraRays rays({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40.0}, film);
  const Tiles tiles(film);
  const Tiles::Lists lists = tiles.lists(index, rays, 1, 100);
  EXPECT_EQ(lists.used, 50u);
  EXPECT_EQ(lists.gaussians_of(0).size(), 50u);
  EXPECT_EQ(lists.gaussians_of(tiles.count() - 1).size(), 50u);
}

}  // namespace
}  // namespace brume
