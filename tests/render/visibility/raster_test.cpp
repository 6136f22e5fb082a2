// The raster against rays, pixel by pixel.

#include "render/visibility/raster.h"
#include "core/scene/camera_rays.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "core/scene/mesh.h"
#include "render/visibility/coordinate_center.h"
#include "render/visibility/ray_caster.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"
#include "tests/render/visibility/box_on_floor.h"

namespace brume {
namespace {

// A surface of three corners for each triangle.
Surface surface_of(const std::vector<glm::dvec3>& corners) {
  MeshArrays mesh;
  mesh.points.assign(corners.begin(), corners.end());
  mesh.normals.assign(corners.size(), {0, 1, 0});
  for (unsigned v = 0; v < corners.size(); v += 3) mesh.triangles.emplace_back(v, v + 1, v + 2);
  Surface surface;
  surface.mesh = to_mesh(mesh);
  return surface;
}

// A ground of two triangles that reaches behind any eye above it, a ball, and triangles of all
// sizes and sides.
std::vector<Surface> mixed_surfaces(Random& random) {
  std::vector<Surface> surfaces{
      surface_of({{-9, -1, -9}, {9, -1, -9}, {9, -1, 9}, {-9, -1, -9}, {9, -1, 9}, {-9, -1, 9}})};
  surfaces.emplace_back().mesh = ball_mesh(24);
  surfaces.back().translate = {0.5, 0.3, 0.0};
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 center = random.point(4.0);
    const double size = random.power(-2.5, 0.0);
    for (int k = 0; k < 3; ++k) corners.push_back(center + random.point(size));
  }
  surfaces.push_back(surface_of(corners));
  return surfaces;
}

// All pixels, row by row; those that no band sets have a negative distance.
std::vector<RasterPixel> drawn(const RayCaster& ray_caster, const CameraRays& rays,
                               const Film& film) {
  const Raster raster = ray_caster.raster(rays, film, {});
  const auto pixels = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  std::vector<RasterPixel> hits(pixels, RasterPixel{-1.0f});
  std::vector<float> distances(pixels, -2.0f);
  for (std::size_t band = 0; band < raster.bands(); ++band) raster.draw(band, hits, distances);
  for (std::size_t i = 0; i < pixels; ++i) EXPECT_EQ(distances[i], hits[i].distance);
  return hits;
}

struct Differences {
  int others = 0;  // pixels of another triangle at another distance
  int hits = 0;
  double distance = 0.0;  // relative, where the triangle is the same
  double weights = 0.0;   // barycentric, of the two large triangles
};

Differences differences(const RayCaster& ray_caster, const CameraRays& rays, const Film& film) {
  Differences result;
  const std::vector<RasterPixel> hits = drawn(ray_caster, rays, film);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const double x = i % static_cast<std::size_t>(film.width);
    const double y = i / static_cast<std::size_t>(film.width);
    EXPECT_GE(hits[i].distance, 0.0f);
    const SurfaceHit hit = ray_caster.hit_of(hits[i]);
    const SurfaceHit ray = ray_caster.first_hit(rays, x + 0.5, y + 0.5);
    if (ray) ++result.hits;
    if (!hit && !ray) continue;
    if (hit.surface == ray.surface && hit.triangle == ray.triangle) {
      result.distance =
          std::max(result.distance, std::abs(hit.distance - ray.distance) / ray.distance);
      if (hit.surface == 0) {
        result.weights = std::max({result.weights, std::abs(static_cast<double>(hit.u - ray.u)),
                                   std::abs(static_cast<double>(hit.v - ray.v))});
      }
    } else if (!(std::abs(hit.distance - ray.distance) < 1e-4 * ray.distance)) {
      ++result.others;
    }
  }
  return result;
}

// All instruction sets of the machine agree, with clipping planes too.
TEST(Raster, HitsAreThoseOfRays) {
  Random random(3);
  const std::vector<Surface> surfaces = mixed_surfaces(random);
  const RayCaster ray_caster(surfaces);
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  int hits = 0;
  int others = 0;
  for (int n = 0; n < 30; ++n) {
    const Film film{120 + 3 * n, 67 + n};
    glm::dvec3 eye = random.point(4.0);
    eye.y = std::abs(eye.y);
    // The widest view puts all but the horizon into the pixels at its center.
    const double fov = n % 5 == 4 ? 179.9 : random.uniform(2.0, 150.0);
    Camera camera{eye, random.point(2.0), {0.2, 1, 0.1}, fov};
    if (n % 3 == 2) {
      for (ClipPlane& plane : camera.clip) {
        plane.normal = glm::normalize(camera.target - eye + random.point(0.5));
        plane.point = eye + random.uniform(-0.2, 1.0) * (camera.target - eye);
      }
    }
    const CameraRays rays(camera, film);
    ASSERT_TRUE(ray_caster.can_rasterize(rays));
    hwy::SetSupportedTargetsForTest(targets[static_cast<std::size_t>(n) % targets.size()]);
    const Differences d = differences(ray_caster, rays, film);
    // At its rim depths along forward are 1/1,000 of distances: so much more do roundings count.
    EXPECT_LT(d.distance, fov > 179.0 ? 5e-3 : 1e-4) << n;
    EXPECT_LT(d.weights, 1e-4) << n;
    hits += d.hits;
    others += d.others;
  }
  hwy::SetSupportedTargetsForTest(0);
  EXPECT_GT(hits, 100'000);
  // Rays that touch an edge.
  EXPECT_LT(others, hits / 5'000);
}

// Single rays, packets of them and the raster see what is behind the plane, or nothing.
TEST(Raster, NothingBeforeAClippingPlaneIsSeen) {
  std::vector<Surface> surfaces(1);
  surfaces[0].mesh = ball_mesh(24);
  const RayCaster ray_caster(surfaces);
  Camera camera{{0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}};
  camera.clip[0] = {{0.0, 0.0, 0.5}, {0.0, 0.0, -1.0}};
  const Film film{64, 48};
  const CameraRays rays(camera, film);
  int behind = 0;
  for (int y = 0; y < film.height; ++y) {
    std::vector<glm::dvec3> row;
    for (int x = 0; x < film.width; ++x) row.push_back(rays.direction(x + 0.5, y + 0.5));
    std::vector<SurfaceHit> hits(row.size());
    ray_caster.first_hits(rays, row, {}, hits);
    for (std::size_t x = 0; x < row.size(); ++x) {
      const SurfaceHit one = ray_caster.first_hit(rays, static_cast<double>(x) + 0.5, y + 0.5);
      ASSERT_EQ(static_cast<bool>(one), static_cast<bool>(hits[x]));
      if (!one) continue;
      // Packets round otherwise than single rays, in float.
      EXPECT_NEAR(one.distance, hits[x].distance, 1e-5);
      EXPECT_LT((rays.eye() + one.distance * row[x]).z, 0.5 + 1e-5);
      ++behind;
    }
  }
  EXPECT_GT(behind, 100);
}

// The interior of a closed mesh has no gaps, its triangles far smaller and far larger than pixels.
TEST(Raster, HasNoGaps) {
  Random random(8);
  for (const int segments : {4, 24, 150}) {
    std::vector<Surface> surfaces(1);
    surfaces[0].mesh = ball_mesh(segments);
    const RayCaster ray_caster(surfaces);
    for (int n = 0; n < 4; ++n) {
      const Film film{333, 111};
      const CameraRays rays({random.point(0.3), random.point(0.5), {0, 1, 0}, 60.0}, film);
      int open = 0;
      for (const RasterPixel& pixel : drawn(ray_caster, rays, film)) {
        if (!std::isfinite(pixel.distance)) ++open;
      }
      EXPECT_EQ(open, 0) << segments;
    }
  }
}

// Their corners are rounded by more than the eye is above them.
TEST(Raster, FindsDepthsOfFloorsFarLargerThanTheirDistance) {
  for (const double size : {1e3, 1e5, 1e6}) {
    const std::array surfaces{two_triangles(size)};
    const RayCaster ray_caster(surfaces);
    const Film film{80, 60};
    const CameraRays rays({{0.3, 0.05, 0.7}, {0.5, 0.0, 0.0}, {0.1, 1, 0}, 40.0}, film);
    ASSERT_TRUE(ray_caster.can_rasterize(rays));
    const std::vector<RasterPixel> hits = drawn(ray_caster, rays, film);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const double x = i % 80;
      const double y = i / 80;
      const glm::dvec3 w = rays.direction(x + 0.5, y + 0.5);
      if (!(w.y < -1e-3)) continue;
      EXPECT_NEAR(static_cast<double>(hits[i].distance) * -w.y / 0.05, 1.0, 2e-4) << size;
    }
  }
}

// Where float has no digits for it.
TEST(Raster, IsAvoidedWhereImprecise) {
  Random random(5);
  const std::vector<Surface> surfaces = mixed_surfaces(random);
  const RayCaster ray_caster(surfaces);
  const auto suits = [&](const glm::dvec3& eye) {
    return ray_caster.can_rasterize(CameraRays({eye, {0, 0, 0}, {0, 1, 0}, 40.0}, {80, 60}));
  };
  EXPECT_TRUE(suits({0, 1, 5}));
  EXPECT_FALSE(suits({0, 1, 5e4}));
  EXPECT_FALSE(RayCaster({}).can_rasterize(CameraRays({}, {80, 60})));
}

// Shadow rays near surfaces whose sizes differ by orders of magnitude.

Surface floor_of(double size) {
  return primitive_surface(Primitive::Shape::plane, {size, 1, size}, {});
}

double difference_to(const Frame& expected, const Scene& scene) {
  return rel_rmse(render_frame(scene, sliced(8)).beauty, expected.beauty);
}

float max_beauty(const Frame& frame) {
  float most = 0.0f;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, frame.beauty[4 * i + c]);
  }
  return most;
}

TEST(ShadowMargins, KeepShadowsOnFloorsOfAnySize) {
  for (const Light& light : {oblique_sun(), light_beside_box(1.0)}) {
    const Frame expected = render_frame(box_on_floor(floor_of(40.0), light), sliced(8));
    for (const double size : {1e4, 1e5, 5e6, 1e7}) {
      EXPECT_LT(difference_to(expected, box_on_floor(floor_of(size), light)), 1e-4) << size;
      EXPECT_LT(difference_to(expected, box_on_floor(two_triangles(size), light)), 1e-4) << size;
    }
  }
}

TEST(ShadowMargins, KeepShadowsOfSmallThings) {
  const Frame expected =
      render_frame(box_on_floor(floor_of(40.0), light_beside_box(1.0)), sliced(8));
  for (const double box : {0.1, 0.001}) {
    const Scene scene = box_on_floor(floor_of(1e4), light_beside_box(box), box);
    EXPECT_LT(difference_to(expected, scene), 1e-4) << box;
  }
}

// The picture is the same but for the sun, which shines at the middle of all.
TEST(ShadowMargins, KeepShadowsBesideFarObjects) {
  for (const Light& light : {oblique_sun(), light_beside_box(1.0)}) {
    const Scene near = box_on_floor(floor_of(40.0), light);
    const Frame expected = render_frame(near, sliced(8));
    for (const double size : {0.1, 2.0, 1e6}) {
      Scene scene = near;
      const glm::dvec3 behind(0.0, 0.0, 2e5 + 10.0 * size);
      scene.surfaces.push_back(
          primitive_surface(Primitive::Shape::sphere, glm::dvec3(size), behind));
      EXPECT_LT(difference_to(expected, scene), 1e-3) << size;
    }
  }
}

// Rounding of coordinates is all that a tilted floor may lose: it is 4e-4 u here.
TEST(ShadowMargins, KeepShadowsOnTiltedFloors) {
  const glm::dquat turn = glm::angleAxis(0.6, glm::dvec3(1, 0, 0));
  const auto tilted = [&](double size) {
    Scene scene = box_on_floor(floor_of(size), light_beside_box(1.0));
    for (Surface& surface : scene.surfaces) {
      surface.translate = turn * surface.translate;
      surface.rotate = turn;
    }
    for (glm::dvec3* p :
         {&scene.camera.eye, &scene.camera.target, &scene.camera.up, &scene.lights[0].position}) {
      *p = turn * *p;
    }
    return scene;
  };
  const Frame expected = render_frame(tilted(40.0), sliced(8));
  EXPECT_LT(difference_to(expected, tilted(1e4)), 2e-2);
}

TEST(ShadowMargins, LeaveClosedRoomsDark) {
  for (const double floor : {20.0, 1e4, 1e5}) {
    const Scene scene = closed_room(floor);
    EXPECT_EQ(max_beauty(render_frame(scene, sliced(8))), 0.0f) << floor;
    EXPECT_EQ(max_beauty(render_frame(scene, path_traced(8))), 0.0f) << floor;
  }
}

TEST(ShadowMargins, LeavePlanesUnshadowedByThemselves) {
  Random random(4);
  for (int n = 0; n < 20; ++n) {
    const glm::dquat turn =
        glm::normalize(glm::dquat(random.uniform(-1.0, 1.0), random.point(1.0)));
    Scene scene = box_on_floor(
        n % 2 == 0 ? floor_of(random.power(0.0, 5.0)) : two_triangles(random.power(0.0, 5.0)),
        oblique_sun());
    scene.surfaces.resize(1);
    scene.surfaces[0].rotate = turn;
    for (glm::dvec3* v : {&scene.camera.eye, &scene.camera.target, &scene.camera.up,
                          &scene.lights[0].as<light::Directional>()->direction}) {
      *v = turn * *v;
    }
    const Frame frame = render_frame(scene, sliced(8));
    const float most = max_beauty(frame);
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (!std::isfinite(frame.depth[i])) continue;
      EXPECT_GT(frame.beauty[4 * i], 0.999f * most) << n;
    }
  }
}

TEST(ShadowMargins, LeaveRoundMeshesUnshadowedByThemselves) {
  for (const double size : {1.0, 1e-3, 1e4}) {
    for (const int rings : {8, 60}) {
      Scene scene = seen_by({size * glm::dvec3(0, 0, 4), {0, 0, 0}, {0, 1, 0}, 40.0}, {80, 60});
      scene.lights = {oblique_sun()};
      scene.lights[0].as<light::Directional>()->direction = {0, 0, -1};
      scene.surfaces.emplace_back().mesh = ball_mesh(rings);
      scene.surfaces[0].scale = size;
      const Frame frame = render_frame(scene, sliced(8));
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        if (!std::isfinite(frame.depth[i])) continue;
        EXPECT_GT(frame.beauty[4 * i], 0.0f) << size;
      }
    }
  }
}

Box cube(const glm::dvec3& center, double size) {
  return {center - 0.5 * size, center + 0.5 * size};
}

Box around(std::span<const Box> boxes) {
  Box all = boxes[0];
  for (const Box& box : boxes) all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  return all;
}

TEST(CoordinateCenter, IsTheMiddleOfOrdinaryScenes) {
  const std::array boxes{cube({0, 0, 0}, 10.0), cube({40, 3, 2}, 0.1)};
  EXPECT_EQ(coordinate_center(around(boxes), boxes),
            0.5 * (around(boxes).low + around(boxes).high));
}

TEST(CoordinateCenter, IsAmongMostWhereOneIsFarAway) {
  for (const double size : {0.01, 1.0, 1e6}) {
    const std::array boxes{cube({1e7, 0, 0}, size), cube({0, 0, 0}, 40.0), cube({1, 0, 0}, 1.0)};
    EXPECT_LT(glm::length(coordinate_center(around(boxes), boxes)), 2.0) << size;
  }
}

}  // namespace

}  // namespace brume
