// Rays on the device against Embree's.

#include "render/gl/mesh_buffers.h"
#include "core/scene/camera_rays.h"

#include <cmath>

#include "render/visibility/triangle_bvh.h"
#include "tests/random.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

Surface surface_of(const MeshArrays& mesh) {
  Surface surface;
  surface.mesh = to_mesh(mesh);
  return surface;
}

// A ball over a floor, both of many triangles that share edges.
std::vector<Surface> ball_on_floor(const glm::dvec3& at) {
  MeshArrays ball;
  add_ball(ball, 20, {0.0, 0.0, 1.0}, 0.8, 3.0, false);
  MeshArrays floor;
  add_floor(floor, 30, 3.0);
  std::vector<Surface> surfaces{surface_of(ball), surface_of(floor)};
  for (Surface& surface : surfaces) surface.translate = at;
  return surfaces;
}

// Triangles of any size and place, some of no area, some of them twice.
std::vector<Surface> random_triangles(int count) {
  Random random(5);
  MeshArrays mesh;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 a = random.point(1.0);
    const glm::dvec3 ab = random.point(1.0) * random.power(-3, 0);
    const glm::dvec3 ac = i % 10 == 0 ? 0.5 * ab : random.point(1.0) * random.power(-3, 0);
    for (int copies = i % 7 == 0 ? 2 : 1; copies > 0; --copies) {
      const std::size_t first = mesh.points.size();
      for (const glm::dvec3& p : {a, a + ab, a + ac}) {
        mesh.points.emplace_back(p);
        mesh.normals.emplace_back(0.0f, 1.0f, 0.0f);
      }
      mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
  }
  return {surface_of(mesh)};
}

class DeviceRays : public GlTest {
 protected:
  // Every pixel of a view, on the device and by Embree. Returns how many rays hit.
  int expect_same_hits(const std::vector<Surface>& surfaces, const Camera& camera) {
    const Film film{160, 120};
    const CameraRays rays(camera, film);
    const RayCaster ray_caster(surfaces);
    mesh_.update(ray_caster);
    depth_.reserve(Texture::Format::r32f, {film.width, film.height});
    mesh_.find_hits(programs_, rays, film, depth_);
    const std::vector<SurfaceHit> hits = mesh_.download_hits();
    int found = 0;
    int others = 0;
    for (int y = 0; y < film.height; ++y) {
      for (int x = 0; x < film.width; ++x) {
        const SurfaceHit& hit = hits[static_cast<std::size_t>(y * film.width + x)];
        const SurfaceHit exact = ray_caster.first_hit(rays.eye(), rays.direction(x + 0.5, y + 0.5));
        found += exact ? 1 : 0;
        // On an edge either triangle is right.
        if (static_cast<bool>(hit) == static_cast<bool>(exact) &&
            (!hit || std::abs(hit.distance - exact.distance) < 1e-5 * exact.distance)) {
          // The smallest triangles are a thousandth across, where roundings are a thousandth of
          // them.
          if (hit && hit.surface == exact.surface && hit.triangle == exact.triangle) {
            EXPECT_NEAR(hit.u, exact.u, 1e-2) << x << ' ' << y;
            EXPECT_NEAR(hit.v, exact.v, 1e-2) << x << ' ' << y;
          }
          continue;
        }
        ++others;
      }
    }
    // Rays past an edge by less than a rounding may miss it.
    EXPECT_LE(others, 2);
    return found;
  }

  void TearDown() override {
    mesh_ = {};
    depth_ = {};
    programs_ = {};
    GlTest::TearDown();
  }

  MeshBuffers mesh_;
  Texture depth_;
  Programs programs_;
};

TEST_F(DeviceRays, MatchEmbree) {
  Camera camera;
  camera.eye = {3.0, -4.0, 2.5};
  camera.target = {0.0, 0.0, 0.5};
  camera.up = {0.0, 0.0, 1.0};
  EXPECT_GT(expect_same_hits(ball_on_floor({0.0, 0.0, 0.0}), camera), 5000);
  EXPECT_GT(expect_same_hits(random_triangles(3000), camera), 1000);
  EXPECT_GT(expect_same_hits(random_triangles(30), camera), 0);
  MeshArrays pair;  // in one leaf
  add_floor(pair, 1, 1.0);
  EXPECT_GT(expect_same_hits({surface_of(pair)}, camera), 1000);
  EXPECT_EQ(expect_same_hits({}, camera), 0);
}

// A closed sheet has no gaps: every ray into the floor hits it.
TEST_F(DeviceRays, PassBetweenNoTriangles) {
  Camera camera;
  camera.eye = {0.0, 0.0, 2.0};
  camera.target = {0.0, 0.0, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.vertical_fov = 60.0;
  MeshArrays floor;
  add_floor(floor, 64, 2.0);
  EXPECT_EQ(expect_same_hits({surface_of(floor)}, camera), 160 * 120);
}

// Far from the origin, and from far away through a narrow lens.
TEST_F(DeviceRays, StayAccurateFarFromTheOrigin) {
  const glm::dvec3 at(1e6, -2e6, 3e6);
  Camera camera;
  camera.up = {0.0, 0.0, 1.0};
  camera.target = at + glm::dvec3(0.0, 0.0, 0.5);
  camera.eye = camera.target + glm::dvec3(3.0, -4.0, 2.0);
  EXPECT_GT(expect_same_hits(ball_on_floor(at), camera), 5000);
  camera.eye = camera.target + 1e4 * glm::dvec3(3.0, -4.0, 2.0);
  camera.vertical_fov = 0.004;
  EXPECT_GT(expect_same_hits(ball_on_floor(at), camera), 5000);
}

TEST(TriangleHierarchies, ContainEveryTriangleOnce) {
  for (const int count : {1, 2, 5, 1000}) {
    const std::vector<Surface> surfaces = random_triangles(count);
    const std::vector<WorldTriangle> triangles = RayCaster(surfaces).triangles();
    const TriangleBvh bvh(triangles);
    std::vector<int> met(triangles.size(), 0);
    for (const TriangleBvh::Node& node : bvh.nodes) {
      for (const TriangleBvh::Child& child : node.children) {
        for (std::int32_t k = 0; k < child.count; ++k) {
          const std::uint32_t i = bvh.order[static_cast<std::size_t>(child.first + k)];
          ++met[i];
          for (const glm::vec3& p : triangles[i].positions) {
            for (int c = 0; c < 3; ++c) {
              EXPECT_GE(p[c], child.low[c]);
              EXPECT_LE(p[c], child.high[c]);
            }
          }
        }
      }
    }
    EXPECT_EQ(met, std::vector<int>(triangles.size(), 1));
  }
  EXPECT_TRUE(TriangleBvh(std::span<const WorldTriangle>()).nodes.empty());
}

}  // namespace
}  // namespace brume::gl
