// What beams tell of triangles against shadow rays, point by point.

#include "render/cpu/lamp_sights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <vector>

#include "core/scene/mesh.h"
#include "render/cpu/surface_kernels.h"
#include "render/renderer.h"
#include "tests/random.h"
#include "tests/render/random_scene.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/benchmark_meshes.h"

namespace brume {
namespace {

// (n + 1)^2 vertices on [-2, 2]^2 at height(x, z).
std::shared_ptr<const TriangleMesh> sheet(int n,
                                          const std::function<double(double, double)>& height) {
  MeshBuilder mesh;
  mesh.grid(n + 1, n + 1, false, [&](double u, double v) {
    const double x = 4.0 * u - 2.0;
    const double z = 4.0 * v - 2.0;
    return glm::dvec3(x, height(x, z), z);
  });
  return mesh.finish();
}

Surface placed(std::shared_ptr<const TriangleMesh> mesh, const glm::dvec3& translate,
               double scale) {
  Surface surface;
  surface.mesh = std::move(mesh);
  surface.translate = translate;
  surface.scale = scale;
  surface.rotate = glm::normalize(glm::dquat(1.0, 0.3, -0.2, 0.5));
  return surface;
}

// A coarse ball of radius 1, whose shadow rays start far outside of it, and flakes that some of
// them meet.
std::shared_ptr<const TriangleMesh> flaked_ball(Random& random) {
  MeshBuilder mesh;
  mesh.ellipsoid(glm::dvec3(0.0), glm::dvec3(1.0), 5);
  for (int i = 0; i < 12; ++i) {
    const glm::dvec3 at = glm::normalize(random.point(1.0)) * random.uniform(0.8, 1.3);
    const glm::dvec3 along = random.point(0.3);
    const glm::dvec3 across = random.point(0.3);
    mesh.grid(2, 2, false, [&](double u, double v) { return at + u * along + v * across; });
  }
  return mesh.finish();
}

// A wavy sheet, balls and flakes above it, another sheet and, in half of the cases, a ball around
// all.
std::vector<Surface> shapes(Random& random, const glm::dvec3& offset, double size) {
  const double waves = random.uniform(0.5, 6.0);
  const double height = random.power(-3.0, -0.5);
  const auto wavy = [=](double x, double z) {
    return height * std::sin(waves * x) * std::cos(0.7 * waves * z);
  };
  const auto somewhere = [&] { return offset + size * random.point(1.0); };
  std::vector<Surface> surfaces;
  surfaces.push_back(placed(sheet(30, wavy), offset, size));
  surfaces.push_back(placed(sheet(3, wavy), somewhere(), 0.3 * size));
  surfaces.push_back(placed(ball_mesh(16), somewhere(), size));
  surfaces.push_back(placed(flaked_ball(random), somewhere(), 0.5 * size));
  if (random.uniform(0.0, 1.0) < 0.5) surfaces.push_back(placed(ball_mesh(12), offset, 4.0 * size));
  return surfaces;
}

struct Counts {
  int asked = 0;  // points that face the lamp
  int whole = 0;
  int none = 0;
  int wrong = 0;  // for which rays find other than their triangle's sight says
};

// Of rays from `eye` that meet one surface.
Counts check(const Visibility& visibility, std::span<const Surface> surfaces,
             const LampSights& sights, const glm::dvec3& lamp, const glm::dvec3& eye,
             std::int32_t surface, Random& random) {
  std::vector<SurfaceHit> hits;
  std::vector<glm::vec3> directions;
  for (int i = 0; i < 400 && hits.size() < Tiles::pixels; ++i) {
    const glm::dvec3 w =
        glm::normalize(visibility.middle() - eye + random.point(1.2 * visibility.radius()));
    const SurfaceHit hit = visibility.first_hit(eye, w);
    if (hit.surface != surface) continue;
    hits.push_back(hit);
    directions.emplace_back(w);
  }
  Counts counts;
  if (hits.empty()) return counts;
  SurfacePoints points;
  visibility.points(hits, directions, surfaces, points);
  const glm::vec3 position(lamp - points.origin);
  LightAtPoints by_rays;
  see_light(points, position, by_rays);
  LightAtPoints by_sights = by_rays;
  visibility.find_lit(points, position, nullptr, by_rays);
  // Often enough that the points' parts are found out about.
  for (std::size_t k = 0; k < points.count; ++k) {
    for (std::uint32_t i = 0; i < LampSights::rays_per_part; ++i) {
      static_cast<void>(sights.of(points.triangle[k], points.side[k], points.u[k], points.v[k]));
    }
  }
  visibility.find_lit(points, position, &sights, by_sights);
  for (std::size_t k = 0; k < points.count; ++k) {
    if (!(by_rays.cosine[k] > 0.0f)) continue;
    const TriangleSight sight =
        sights.of(points.triangle[k], points.side[k], points.u[k], points.v[k]);
    ++counts.asked;
    counts.whole += sight == TriangleSight::whole ? 1 : 0;
    counts.none += sight == TriangleSight::none ? 1 : 0;
    counts.wrong += by_rays.lit[k] != by_sights.lit[k] ? 1 : 0;
  }
  return counts;
}

TEST(LampSights, AreWhatShadowRaysFind) {
  Random random(1);
  Counts all;
  for (int scene = 0; scene < 60; ++scene) {
    const glm::dvec3 offset = scene % 5 == 4 ? glm::dvec3(1e4, -2e4, 3e3) : glm::dvec3(0.0);
    const double size = random.power(-2.0, 2.0);
    const std::vector<Surface> surfaces = shapes(random, offset, size);
    const Visibility visibility(surfaces);
    const TriangleBeams beams(visibility);
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 lamp = offset + random.point(random.power(-0.5, i == 3 ? 5.0 : 1.0) * size);
      LampSights sights(beams, lamp - visibility.middle());
      for (std::uint32_t frame = 0; frame < LampSights::rounds; ++frame) {
        sights.begin_frame();
        for (std::uint32_t t = 0; t < beams.size(); ++t) static_cast<void>(sights.of(t, 1.0f));
      }
      for (int view = 0; view < 6; ++view) {
        const glm::dvec3 eye = offset + random.point(random.power(-0.5, 1.0) * size);
        for (std::int32_t s = 0; s < static_cast<std::int32_t>(surfaces.size()); ++s) {
          const Counts counts = check(visibility, surfaces, sights, lamp, eye, s, random);
          all.asked += counts.asked;
          all.whole += counts.whole;
          all.none += counts.none;
          all.wrong += counts.wrong;
        }
      }
    }
  }
  EXPECT_EQ(all.wrong, 0);
  EXPECT_GT(all.asked, 50'000);
  EXPECT_GT(all.whole, all.asked / 4);
  EXPECT_GT(all.none, all.asked / 10);
}

TEST(TrianglePart, HoldsItsPoints) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const double u = random.uniform(0.0, 1.0);
    const double v = random.uniform(0.0, 1.0 - u);
    const std::uint32_t part = TrianglePart::at(static_cast<float>(u), static_cast<float>(v));
    ASSERT_TRUE(TrianglePart::exists(part));
    const double column = part / 2 / TrianglePart::along;
    const double row = part / 2 % TrianglePart::along;
    const double x = u * TrianglePart::along - column;
    const double y = v * TrianglePart::along - row;
    EXPECT_TRUE(x >= -1e-6 && x <= 1.0 + 1e-6 && y >= -1e-6 && y <= 1.0 + 1e-6) << u << " " << v;
    EXPECT_TRUE(part % 2 == 1 ? x + y >= 1.0 - 1e-6 : x + y <= 1.0 + 1e-6) << u << " " << v;
  }
  // What roundings leave outside.
  for (const float u : {-1e-7f, 0.0f, 0.5f, 1.0f, 1.0000001f}) {
    EXPECT_TRUE(TrianglePart::exists(TrianglePart::at(u, 1.0000001f - u)));
  }
}

// The shape that they are for.
TEST(LampSights, KnowMostOfABallAndItsShadow) {
  const std::vector<Surface> surfaces{
      placed(sheet(60, [](double, double) { return 0.0; }), glm::dvec3(0.0), 1.0),
      placed(ball_mesh(48), {0.0, 1.0, 0.3}, 0.4)};
  const Visibility visibility(surfaces);
  const TriangleBeams beams(visibility);
  const glm::dvec3 lamp = glm::dvec3(0.5, 9.0, 1.0) - visibility.middle();
  std::array<int, 4> counts{};
  int parts = 0;
  int unknown_parts = 0;
  for (std::uint32_t t = 0; t < beams.size(); ++t) {
    const auto sight = beams.sight(lamp, t).of_points;
    ++counts[static_cast<std::size_t>(sight)];
    if (sight != TriangleSight::in_part) continue;
    for (std::uint32_t part = 0; part < TrianglePart::count; ++part) {
      if (!TrianglePart::exists(part)) continue;
      ++parts;
      unknown_parts += beams.sight_of_part(lamp, t, part) == TriangleSight::in_part ? 1 : 0;
    }
  }
  const auto share = [&](TriangleSight sight) {
    return static_cast<double>(counts[static_cast<std::size_t>(sight)]) /
           static_cast<double>(beams.size());
  };
  EXPECT_EQ(share(TriangleSight::unknown), 0.0);
  EXPECT_LT(share(TriangleSight::in_part), 0.1);
  // Most of these are the ball's own, at the border of its dark side.
  EXPECT_LT(unknown_parts, parts * 3 / 5);
}

// Lamps and shadows only; and no surface is diffuse: what those send is kept from frame to frame
// too, which is not exact.
Scene with_sights_only(Scene scene) {
  scene.medium = Medium();
  scene.environment.reset();
  for (Surface& surface : scene.surfaces) {
    surface.transfer = Surface::Transfer::none;
    if (surface.material.type == Material::Type::diffuse) {
      surface.material.type = Material::Type::phong;
    }
  }
  return scene;
}

TEST(LampSights, ChangeNoFrame) {
  const Settings settings;
  int seen = 0;
  // In the last one a lamp stands on a surface.
  for (unsigned seed = 0; seed <= 1000; ++seed) {
    if (seed == 1000) seed = 2981;
    Scene scene = with_sights_only(random_scene(seed));
    if (scene.surfaces.empty() || scene.lights.empty()) continue;
    scene.film = {24, 16};
    Renderer renderer;
    const Frame first = *renderer.render(scene, scene.camera, scene.film, settings);
    for (std::uint32_t frame = 0; frame < LampSights::rounds + 1; ++frame) {
      const Frame later = *renderer.render(scene, scene.camera, scene.film, settings);
      ASSERT_EQ(later.beauty, first.beauty) << "seed " << seed << ", frame " << frame + 2;
    }
    seen += std::ranges::any_of(first.depth, [](float d) { return std::isfinite(d); }) ? 1 : 0;
  }
  EXPECT_GT(seen, 30);
}

// What was known before something moved is not believed after it.
TEST(LampSights, GoWithLampsAndSurfaces) {
  Random random(2);
  Scene scene;
  scene.surfaces = shapes(random, glm::dvec3(0.0), 1.0);
  scene.lights = {{{0.5, 3.0, 1.0}, {30, 30, 30}, {}}};
  scene.camera.eye = {0.0, 2.5, 4.0};
  scene.film = {160, 120};
  scene = with_sights_only(scene);
  const Settings settings;
  Renderer renderer;
  Frame last;
  for (int step = 0; step < 3; ++step) {
    for (std::uint32_t frame = 0; frame < LampSights::rounds + 2; ++frame) {
      last = *renderer.render(scene, scene.camera, scene.film, settings);
    }
    EXPECT_EQ(last.beauty, render_frame(scene, settings).beauty) << step;
    if (step == 0) scene.surfaces[2].translate += glm::dvec3(0.3, 0.2, 0.0);
    if (step == 1) scene.lights[0].position = {-1.5, 2.0, 0.5};
  }
}

}  // namespace
}  // namespace brume
