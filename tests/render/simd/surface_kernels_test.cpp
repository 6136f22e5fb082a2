// Surfaces in single precision SIMD against the same in plain double, point by point.

#include "render/simd/surface_kernels.h"
#include "core/scene/camera_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/scene/lights/area_lights.h"
#include "core/scene/materials/brdf.h"
#include "core/scene/materials/ggx_sh.h"
#include "render/simd/area_kernels.h"
#include "render/simd/ggx_kernels.h"
#include "render/simd/reflection_kernels.h"
#include "render/visibility/ray_caster.h"
#include "tests/core/math/sh_convolve.h"
#include "tests/core/transport/incident_light.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// A ball, a shell inside out and a flat triangle, seen from where rays start.
struct Seen {
  std::vector<Surface> surfaces;
  std::unique_ptr<RayCaster> ray_caster;
  glm::dvec3 eye;
  std::vector<SurfaceHit> hits;
  std::vector<glm::vec3> directions;
};

// `count` hits on surface `which`; all is `offset` away from the origin and `size` large.
Seen look(std::int32_t which, std::size_t count, const glm::dvec3& offset, double size,
          Random& random) {
  Seen seen;
  for (const double scale : {1.0, 3.0}) {
    Surface& surface = seen.surfaces.emplace_back();
    surface.mesh = ball_mesh(24);
    surface.scale = scale * size;
    surface.translate = offset + size * glm::dvec3(0.2, 0.1 * scale, 0.0);
    surface.rotate = glm::normalize(glm::dquat(1.0, 0.3, -0.2, 0.5));
  }
  seen.ray_caster = std::make_unique<RayCaster>(seen.surfaces);
  seen.eye = offset + size * glm::dvec3(0.3, 0.4, 2.2);
  while (seen.hits.size() < count) {
    const glm::dvec3 w = glm::normalize(random.point(1.0));
    const SurfaceHit hit = seen.ray_caster->first_hit(seen.eye, w);
    if (hit.surface != which) continue;
    seen.hits.push_back(hit);
    seen.directions.emplace_back(w);
  }
  return seen;
}

void expect_close(const glm::dvec3& got, const glm::dvec3& expected, double tolerance,
                  const char* what) {
  EXPECT_LT(glm::length(got - expected), tolerance) << what;
}

TEST(SurfaceKernels, ViewDirectionsAreThoseOfThePlainVersion) {
  for (const double fov : {0.01, 40.0, 150.0}) {
    const Film film{1003, 601};
    const CameraRays rays({{1, 2, 3}, {-4, 0.5, 1}, {0.1, 1, 0}, fov}, film);
    for (const CameraRays::PixelRectangle& r :
         {CameraRays::PixelRectangle{0, 0, 16, 8}, {992, 600, 1003, 601}, {512, 304, 517, 307}}) {
      std::vector<glm::ivec2> pixels;
      Tiles::each_pixel(r, [&](int x, int y) { pixels.emplace_back(x, y); });
      PointVectors directions;
      find_view_directions(rays, pixels, directions);
      std::size_t k = 0;
      for (const glm::ivec2& p : pixels) {
        expect_close(directions[k++], rays.direction(p.x + 0.5, p.y + 0.5), 2e-7, "direction");
      }
      for (std::size_t i = k; i < padded(k); ++i) EXPECT_EQ(directions[i], directions[k - 1]);
    }
  }
}

TEST(SurfaceKernels, PointsAreThoseOfThePlainVersion) {
  Random random(1);
  for (const double size : {1.0, 1e-4, 1e4}) {
    for (const std::int32_t which : {0, 1}) {
      for (const std::size_t count : {1u, 15u, 16u, 100u, 128u}) {
        const Seen seen = look(which, count, 100.0 * size * random.point(1.0), size, random);
        SurfacePoints points;
        seen.ray_caster->points(seen.hits, seen.eye, seen.directions, {}, seen.surfaces, points);
        ASSERT_EQ(points.count, count);
        EXPECT_EQ(points.surface, &seen.surfaces[static_cast<std::size_t>(which)]);
        for (std::size_t k = 0; k < count; ++k) {
          const SurfacePoint plain = seen.ray_caster->point(
              seen.hits[k], seen.eye, glm::dvec3(seen.directions[k]), seen.surfaces);
          // Embree's own distance is good to a few 1e-6 of the surfaces' size.
          expect_close(points.origin + points.position[k], plain.position, 2e-5 * size, "position");
          expect_close(points.origin + points.shadow_origin[k], plain.shadow_origin, 2e-5 * size,
                       "shadow origin");
          expect_close(points.normal[k], plain.normal, 2e-5, "normal");
          expect_close(points.to_eye[k], plain.to_eye, 1e-6, "to eye");
        }
      }
    }
  }
}

TEST(SurfaceKernels, TrianglesWithoutNormalsHaveTheSideOfTheirWinding) {
  Surface surface;
  surface.mesh = to_mesh({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}},
                          std::vector<glm::vec3>(3, glm::vec3(0.0f)),
                          {{0, 1, 2}}});
  const std::array surfaces{surface};
  const RayCaster ray_caster(surfaces);
  for (const double side : {1.0, -1.0}) {
    const glm::dvec3 eye(0.1, 0.1, 2.0 * side);
    const glm::dvec3 w(0.0, 0.0, -side);
    const std::vector hits{ray_caster.first_hit(eye, w)};
    SurfacePoints points;
    ray_caster.points(hits, eye, std::vector{glm::vec3(w)}, {}, surfaces, points);
    EXPECT_EQ(points.normal[0], glm::dvec3(0, 0, side));
    EXPECT_EQ(points.side[0], side);
    EXPECT_EQ(ray_caster.point(hits[0], eye, w, surfaces).normal, glm::dvec3(0, 0, side));
  }
}

TEST(SurfaceKernels, LightIsThatOfThePlainVersion) {
  Random random(2);
  std::array<PointArray, sh_max_bands> factors;
  int lit = 0;
  for (int scene = 0; scene < 20; ++scene) {
    const Seen seen = look(scene % 2, 128, glm::dvec3(0.0), 1.0, random);
    SurfacePoints points;
    seen.ray_caster->points(seen.hits, seen.eye, seen.directions, {}, seen.surfaces, points);
    Material material;
    material.type = scene % 3 == 0 ? Material::Type::phong : Material::Type::diffuse;
    material.reflectance = {0.2, 0.5, 0.9};
    material.specular = glm::dvec3(0.4);
    material.exponent = random.power(0.0, 2.5);
    // Inside the shell, some close to the ball, some in it.
    const glm::dvec3 light = random.point(2.0);
    const double density = random.uniform(0.0, 0.5);

    LightAtPoints light_at_point;
    point_to_light(points, PointLight{.position = light}, light_at_point);
    seen.ray_caster->trace_shadow_rays(points, glm::vec3(light - points.origin), light_at_point);
    for (float& depth : light_at_point.depths) depth = static_cast<float>(random.power(-3.0, 1.3));
    PointLightShading shading;
    shading.intensity = {3.0f, 2.0f, 1.0f};
    shading.diffuse = glm::vec3(material.reflectance * std::numbers::inv_pi);
    if (material.type == Material::Type::phong) {
      shading.highlight =
          glm::vec3(material.specular * (material.exponent + 2.0) / (2.0 * std::numbers::pi));
      shading.exponent = static_cast<float>(material.exponent);
    }
    PointRadiance direct{};
    PointRadiance scattered{};
    add_direct_light(points, light_at_point, shading, direct);
    find_spread(light_at_point, points.padded_size(),
                {&ScatterTable::point(), &ScatterTable::distant(), static_cast<float>(density)},
                true, factors);
    add_scattered_light(points, light_at_point, factors, shading, scattered);

    for (std::size_t k = 0; k < points.count; ++k) {
      const glm::dvec3 p = points.origin + points.position[k];
      const double distance = glm::length(light - p);
      const glm::dvec3 wi = (light - p) / distance;
      const double cosine = glm::dot(points.normal[k], wi);
      const bool blocked =
          seen.ray_caster->occluded(points.origin + points.shadow_origin[k], light);
      const double T = light_at_point.depths[k];
      const double irradiance = 3.0 / (distance * distance);
      glm::dvec3 expected(0.0);
      if (!blocked) {
        expected = brdf(material, wi, points.to_eye[k], points.normal[k]) *
                   (irradiance * std::exp(-T) * std::max(cosine, 0.0));
        ++lit;
      }
      // A power of 300 makes 300 times as much of a rounding.
      EXPECT_NEAR(direct.r[k], expected.r, 3e-4 * expected.r + 1e-7);

      // Eq. 25 without its delta, convolved with the cosine.
      const double homogeneous_fraction = density * distance < T ? density * distance / T : 1.0;
      ZonalSh<double> spread = SpreadTable::distant()(T);
      const ZonalSh<double> near = SpreadTable::point()(T);
      for (std::size_t l = 0; l < spread.size(); ++l)
        spread[l] += homogeneous_fraction * (near[l] - spread[l]);
      const ShVector<double> light_sh = sh_convolve(sh_basis(sh_max_bands, wi), spread);
      const double reflected =
          std::max(0.0, sh_evaluate(sh_convolve(light_sh, clamped_cosine_sh()), points.normal[k]));
      const double scale = irradiance * 0.2 * std::numbers::inv_pi;
      EXPECT_NEAR(scattered.r[k], scale * T * std::exp(-T) * reflected, 5e-5 * scale);
      EXPECT_NEAR(scattered.b[k], scattered.r[k] * (0.9 / 0.2) / 3.0, 1e-5 * scale);
    }
  }
  EXPECT_GT(lit, 500);
}

TEST(SurfaceKernels, ALightOnTheSurfaceContributesNothing) {
  Random random(3);
  const Seen seen = look(0, 5, glm::dvec3(0.0), 1.0, random);
  SurfacePoints points;
  seen.ray_caster->points(seen.hits, seen.eye, seen.directions, {}, seen.surfaces, points);
  LightAtPoints light_at_point;
  point_to_light(points, PointLight{.position = points.origin + points.position[2]},
                 light_at_point);
  light_at_point.depths.fill(0.0f);
  light_at_point.lit.fill(1.0f);
  PointRadiance radiance{};
  add_direct_light(points, light_at_point,
                   {glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f), 10.0f}, radiance);
  EXPECT_EQ(radiance.r[2], 0.0f);
}

// Area lights at surfaces in single precision against the plain version.

void expect_plain_irradiance(const AreaLight& area, double tolerance) {
  Random random(5);
  const glm::dvec3 middle(100.2, 50.3, -20.1);
  auto points = std::make_unique<SurfacePoints>();
  points->count = Tiles::pixels;
  points->origin = middle + glm::dvec3(0.5, -0.3, 0.2);
  LightAtPoints light{};
  light.paths.resize(points->count);
  AreaSum sum;
  sum.clear();
  for (std::size_t k = 0; k < points->count; ++k) {
    points->position.set(k, glm::vec3(random.point(2.0)));
    points->normal.set(k, glm::vec3(glm::normalize(random.point(1.0))));
    light.cosine[k] = 0.5f;
    light.inverse_square[k] = 0.25f;
    light.depths[k] = 0.7f;
    for (PointArray* channel : {&sum.radiance.r, &sum.radiance.g, &sum.radiance.b}) {
      (*channel)[k] = 0.5f * 0.25f * 3.0f;  // what add() counts
    }
  }
  sum.add(*points, light, 3.0f);
  PointRadiance found{};
  sum.add_to(*points, {area, middle, points->origin}, found);
  for (std::size_t k = 0; k < points->count; ++k) {
    const double expected = area_irradiance(area, middle, points->origin + points->position[k],
                                            glm::normalize(points->normal[k]));
    EXPECT_NEAR(found.g[k], expected, tolerance * expected + 1e-6) << area.index() << " " << k;
    EXPECT_NEAR(sum.transmittance(k), std::exp(-0.7), 1e-5);
  }
}

TEST(AreaKernels, SendAsMuchAsThePlainVersion) {
  expect_plain_irradiance(
      light::Rectangle{
          .direction = {0.3, -1.0, 0.2}, .width = 1.4, .height = 0.6, .two_sided = true},
      2e-5);
  expect_plain_irradiance(light::Sphere{0.5, true}, 2e-5);
  expect_plain_irradiance(light::Sphere{0.5, false}, 2e-5);
  // A polygon stands for it.
  expect_plain_irradiance(light::Disk{{0.3, -1.0, 0.2}, 0.5, false}, 5e-3);
}

// Metallic-roughness reflection in single precision against the plain version.

struct GgxCase {
  std::unique_ptr<SurfacePoints> points = std::make_unique<SurfacePoints>();
  std::vector<GgxReflection> reflections;

  explicit GgxCase(Random& random) {
    points->count = Tiles::pixels;
    for (std::size_t k = 0; k < points->count; ++k) {
      const glm::dvec3 n = glm::normalize(random.point(1.0));
      glm::dvec3 to_eye = glm::normalize(random.point(1.0));
      if (k % 8 == 1) to_eye = n;
      if (glm::dot(n, to_eye) < 0.0) to_eye -= 2.0 * glm::dot(n, to_eye) * n;
      const glm::dvec3 base(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
      const double metallic = random.uniform(0, 1);
      const double roughness = k % 8 == 2 ? 0.0 : random.uniform(0, 1);
      const GgxReflection& r = reflections.emplace_back(base, metallic, roughness);
      points->normal.set(k, glm::vec3(n));
      points->to_eye.set(k, glm::vec3(to_eye));
      points->ggx.diffuse.set(k, glm::vec3(r.diffuse));
      points->ggx.f0.set(k, glm::vec3(r.f0));
      points->ggx.alpha[k] = static_cast<float>(r.alpha);
      points->ggx.lobe[k] = 1.0f;
    }
  }
};

TEST(GgxKernels, ReflectLightsAsThePlainVersion) {
  Random random(6);
  GgxCase c(random);
  LightAtPoints light{};
  light.paths.resize(c.points->count);
  for (std::size_t k = 0; k < c.points->count; ++k) {
    // Half of the lights in the highlight.
    const glm::dvec3 n = c.points->normal[k];
    const glm::dvec3 to_eye = c.points->to_eye[k];
    const double near = c.reflections[k].alpha;
    glm::dvec3 wi = k % 2 == 0 ? random.point(1.0)
                               : 2.0 * glm::dot(n, to_eye) * n - to_eye + random.point(near);
    wi = glm::normalize(wi);
    light.paths.x[k] = static_cast<float>(-wi.x);
    light.paths.y[k] = static_cast<float>(-wi.y);
    light.paths.z[k] = static_cast<float>(-wi.z);
    light.cosine[k] = static_cast<float>(glm::dot(n, wi));
    light.inverse_square[k] = 0.25f;
    light.depths[k] = 0.5f;
    light.lit[k] = k % 16 == 5 ? 0.0f : 1.0f;
  }
  PointRadiance found{};
  add_ggx_light(*c.points, PointLight{.intensity = {1.0, 2.0, 3.0}}, light, found);
  for (std::size_t k = 0; k < c.points->count; ++k) {
    const glm::dvec3 wi(-light.paths.x[k], -light.paths.y[k], -light.paths.z[k]);
    const double cosine = light.cosine[k];
    glm::dvec3 expected(0.0);
    if (cosine > 0.0 && light.lit[k] > 0.0f) {
      expected = ggx_brdf(c.reflections[k], glm::normalize(wi), glm::normalize(c.points->to_eye[k]),
                          glm::normalize(c.points->normal[k])) *
                 glm::dvec3(1.0, 2.0, 3.0) * cosine * 0.25 * std::exp(-0.5);
    }
    const glm::dvec3 got(found.r[k], found.g[k], found.b[k]);
    // Directions of single precision move the sharpest highlights by a ten-thousandth of their
    // width.
    EXPECT_NEAR(glm::length(got - expected), 0.0, 2e-3 * glm::length(expected) + 1e-7) << k;
  }
}

TEST(GgxKernels, ReflectHarmonicsAsThePlainVersion) {
  Random random(7);
  GgxCase c(random);
  auto light = std::make_unique<IncidentLight>();
  light->clear();
  std::vector<ShVector<glm::dvec3>> lights;
  for (std::size_t k = 0; k < c.points->count; ++k) {
    ShVector<glm::dvec3>& given = lights.emplace_back(sh_max_bands);
    for (std::size_t i = 0; i < given.size(); ++i) given[i] = random.point(1.0);
    light->add(k, given);
  }
  PointRadiance found{};
  reflect_ggx(*c.points, *light, found);
  for (std::size_t k = 0; k < c.points->count; ++k) {
    const glm::dvec3 n = c.points->normal[k];
    const glm::dvec3 wo = c.points->to_eye[k];
    const glm::dvec3 expected =
        sh_dot(lights[k], sh_rotate(GgxSh::table()(c.reflections[k], glm::dot(n, wo)),
                                    surface_frame(glm::normalize(n), glm::normalize(wo))));
    if (k % 8 == 1) continue;  // the frame of an eye along the normal is any
    EXPECT_NEAR(glm::length(glm::dvec3(found.r[k], found.g[k], found.b[k]) - expected), 0.0, 2e-4)
        << k;
  }
}

}  // namespace

}  // namespace brume
