#include "render/geometry/sphere_bvh.h"
#include "core/scene/camera_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "render/geometry/edge_on.h"
#include "render/geometry/fog_ball.h"
#include "render/geometry/tiles.h"
#include "render/quality/auto_quality.h"
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

TEST(FogBall, IntervalsAreWhereRaysAreInIt) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const FogBall ball{random.point(2.0), random.uniform(0.5, 3.0)};
    const glm::dvec3 x = random.point(5.0);
    const glm::dvec3 w = glm::normalize(random.point(1.0));
    const double distance = random.uniform(0.0, 10.0);
    double length = 0.0;
    double first = 0.0;
    constexpr int steps = 20000;
    constexpr double step = 20.0 / steps;
    const FogInterval interval = ball.interval(x, w);
    double in_interval = 0.0;
    for (int k = 0; k < steps; ++k) {
      const double t = step * (k + 0.5);
      if (interval.contains(t)) in_interval += step;
      if (!ball.contains(x + t * w)) continue;
      length += step;
      if (t < distance) first += step;
    }
    EXPECT_NEAR(in_interval, length, 2.0 * step);
    EXPECT_NEAR(interval.end - interval.begin, length, 2.0 * step);
    EXPECT_NEAR(ball.length(x, w), length, 2.0 * step);
    EXPECT_NEAR(ball.length(x, w, distance), first, 2.0 * step);
    EXPECT_NEAR(interval.before(distance), first, 2.0 * step);
  }
}

TEST(FogBall, EndlessFogIsAllTheWay) {
  const FogBall everywhere;
  const glm::dvec3 x(1.0, 2.0, 3.0);
  const glm::dvec3 w(0.0, 1.0, 0.0);
  EXPECT_EQ(everywhere.length(x, w, 5.0), 5.0);
  EXPECT_EQ(everywhere.length(x, w), infinity);
  EXPECT_EQ(everywhere.interval(x, w).before(7.0), 7.0);
  EXPECT_TRUE(everywhere.contains(x));
}

// Nothing is lost next to the middle of a ball of a million units.
TEST(FogBall, LargeBallsKeepShortWays) {
  const FogBall ball{{1.0, 0.0, 0.0}, 1e6};
  const glm::dvec3 w = glm::normalize(glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(ball.length({0.5, 0.25, 0.0}, w, 0.125), 0.125);
  EXPECT_NEAR(ball.length({0.5, 0.25, 0.0}, w), 1e6, 2.0);
}

TEST(FogBall, MeanLengthIsThatOverDirections) {
  const FogBall ball{{0.5, -1.0, 2.0}, 1.5};
  for (const double s : {0.0, 1e-5, 0.01, 0.5, 0.99, 1.01, 2.0, 10.0}) {
    const glm::dvec3 x = ball.center + s * ball.radius * glm::dvec3(0.0, 0.0, 1.0);
    double sum = 0.0;
    constexpr int steps = 200000;
    for (int k = 0; k < steps; ++k) {  // over the cosine from the axis
      const double cosine = -1.0 + 2.0 * (k + 0.5) / steps;
      sum += ball.length(x, {std::sqrt(1.0 - cosine * cosine), 0.0, cosine}) / steps;
    }
    EXPECT_NEAR(ball.mean_length(x), sum, 1e-4) << s;
  }
}

// Surfaces whose plane the eye lies in.

// A floor at y = 0 of cells x cells squares, 2 u to each side.
Surface make_floor(int cells) {
  MeshArrays mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const auto x = 4.0f * static_cast<float>(j) / static_cast<float>(cells) - 2.0f;
      const auto z = 4.0f * static_cast<float>(i) / static_cast<float>(cells) - 2.0f;
      mesh.points.emplace_back(x, 0.0f, z);
      mesh.normals.emplace_back(0, 1, 0);
    }
  }
  const auto at = [&](int i, int j) { return static_cast<unsigned>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  Surface surface;
  surface.mesh = to_mesh(mesh);
  return surface;
}

// Fog over a floor, seen by an eye in its plane but for `off`.
Scene on_the_floor(const glm::dvec3& eye, const glm::dvec3& target, double off, int cells) {
  Scene scene = cloud_scene(10, 1.0);
  scene.camera.eye = eye + glm::dvec3(0.0, off, 0.0);
  scene.camera.target = target;
  scene.film = {32, 25};
  scene.surfaces.push_back(make_floor(cells));
  return scene;
}

std::size_t hits(const Frame& frame) {
  return static_cast<std::size_t>(
      std::ranges::count_if(frame.depth, [](float t) { return std::isfinite(t); }));
}

// From next to the floor and on it, ahead, askew, up and down; few triangles are rasterized, many
// hit by rays.
TEST(EdgeOn, PlanesThroughTheEyeAreInvisible) {
  for (const int cells : {1, 3, 30}) {
    for (const glm::dvec3& eye :
         {glm::dvec3(0, 0, 5), glm::dvec3(3, 0, 4), glm::dvec3(0.3, 0, 0.7)}) {
      for (const double target : {0.0, 0.3, -0.4}) {
        for (const double off : {0.0, 1e-9, -2e-8}) {
          SCOPED_TRACE(testing::Message() << cells << " cells, eye at " << eye.x << ' ' << eye.z
                                          << ", target " << target << ", off by " << off);
          const Scene scene = on_the_floor(eye, {0.1, target, 0.0}, off, cells);
          EXPECT_EQ(hits(render_frame(scene, sliced_settings({}, 8))), 0U);
        }
      }
    }
  }
}

TEST(EdgeOn, PlanesJustBelowTheEyeAreVisible) {
  const Scene scene = on_the_floor({0.3, 0.0, 0.7}, {0.1, 0.0, 0.0}, 1e-3, 3);
  EXPECT_GT(hits(render_frame(scene, sliced_settings({}, 8))), 32U * 12U);
}

TEST(EdgeOn, MethodsAndTheErrorAgree) {
  for (const double off : {0.0, 1e-9}) {
    const Scene scene = on_the_floor({0, 0, 5}, {0, 0, 0}, off, 3);
    Settings reference_settings;
    reference_settings.airlight = AirlightMethod::reference;
    const Frame reference = render_frame(scene, reference_settings);
    const Frame frame = render_frame(scene, sliced_settings({}, 32));
    EXPECT_EQ(hits(reference), 0U);
    EXPECT_LT(rel_rmse(frame.airlight, reference.airlight), 0.02);
    const auto error = measure_error(scene, scene.camera, frame);
    ASSERT_TRUE(error);
    EXPECT_LT(error->airlight.high, 0.05);
  }
}

TEST(EdgeOn, TrianglesWithoutAnAreaAlwaysAre) {
  EXPECT_TRUE(is_edge_on({glm::vec3(0.0f), glm::vec3(1.0f), glm::vec3(2.0f)}, {0, 5, 0}));
  EXPECT_FALSE(is_edge_on({glm::vec3(0.0f), {1, 0, 0}, {0, 0, 1}}, {0, 5, 0}));
  EXPECT_FALSE(is_edge_on({glm::vec3(0.0f), {1, 0, 0}, {0, 0, 1}}, {0, 1e-7, 0}));
  EXPECT_TRUE(is_edge_on({glm::vec3(0.0f), {1, 0, 0}, {0, 0, 1}}, {9, 2e-7, 9}));
}

}  // namespace

}  // namespace brume
