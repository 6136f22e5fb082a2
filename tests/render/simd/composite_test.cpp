// The compositing of rows in single precision SIMD against plain double, pixel by pixel.

#include "render/cpu/composite.h"
#include "core/scene/camera_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <vector>

#include "core/scene/lights/environment.h"
#include "render/simd/composite_kernels.h"
#include "render/simd/reflection_kernels.h"
#include "render/transfer/sh_material.h"
#include "tests/random.h"

namespace brume {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

Environment random_sky(int width, int height) {
  Random random(5);
  RadianceMap map{width, height, {}};
  for (int i = 0; i < width * height; ++i) map.pixels.emplace_back(glm::abs(random.point(1.0)));
  Environment sky;
  sky.map = std::make_shared<const RadianceMap>(std::move(map));
  sky.intensity = 2.0;
  sky.rotation = 33.0;
  return sky;
}

// A frame with objects in some places.
Frame random_frame(const Film& film) {
  Random random(6);
  Frame frame;
  frame.film = film;
  const auto pixels = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  frame.beauty.resize(4 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    frame.depth.push_back(random.uniform(0.0, 1.0) < 0.3 ? 2.0f : infinite);
    const auto transmittance = static_cast<float>(random.uniform(0.0, 1.0));
    for (int c = 0; c < 3; ++c) {
      frame.airlight.push_back(static_cast<float>(random.uniform(0.0, 1.0)));
      frame.transmittance.push_back(transmittance);
    }
  }
  return frame;
}

// Cameras that look at the seam of the map, at its poles, and at all sides in films whose rows are
// no whole vectors, or shorter than one.
TEST(Composite, ShowsTheSkyAndTheSurfaces) {
  struct Case {
    glm::dvec3 target;
    Film film;
    int map_width, map_height;
  };
  for (const Case& c : {Case{{0, 0, 1}, {67, 5}, 64, 32}, Case{{0.01, 1, 0}, {33, 33}, 64, 32},
                        Case{{0.01, -1, 0}, {32, 31}, 7, 5}, Case{{1, 0.2, 0.3}, {5, 40}, 1, 1},
                        Case{{-0.3, 0.1, -1}, {130, 3}, 2, 1}}) {
    const Environment sky = random_sky(c.map_width, c.map_height);
    const EnvironmentLight light(sky, ScatterTable::distant());
    const Camera camera{{0, 0, 0}, c.target, {0, 1, 0}, 120.0};
    const CameraRays rays(camera, c.film);
    Frame frame = random_frame(c.film);
    const std::vector<glm::vec3> surfaces(frame.depth.size(), glm::vec3(0.3f, 0.2f, 0.1f));
    composite(rays, &light, surfaces, {}, frame);
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      const int x = static_cast<int>(i) % c.film.width;
      const int y = static_cast<int>(i) / c.film.width;
      const bool is_sky = std::isinf(frame.depth[i]);
      const glm::dvec3 behind = is_sky ? environment_radiance(sky, rays.direction(x + 0.5, y + 0.5))
                                       : glm::dvec3(surfaces[i]);
      const double transmittance = frame.transmittance[3 * i];
      for (std::size_t k = 0; k < 3; ++k) {
        const double expected = static_cast<double>(frame.airlight[3 * i + k]) +
                                transmittance * behind[static_cast<int>(k)];
        ASSERT_NEAR(frame.beauty[4 * i + k], expected, 1e-4)
            << c.film.width << ": " << x << ' ' << y;
      }
      ASSERT_FLOAT_EQ(frame.beauty[4 * i + 3], is_sky ? 1.0f - frame.transmittance[3 * i] : 1.0f);
    }
  }
}

TEST(Composite, BackgroundIsBlackWithoutAnEnvironment) {
  Frame frame = random_frame({20, 2});
  composite(CameraRays({}, frame.film), nullptr, {}, {}, frame);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    EXPECT_EQ(frame.beauty[4 * i + 1], frame.airlight[3 * i + 1]);
  }
}

// NaNs and values beyond the range are as finite() has them, in whole vectors and after them.
TEST(Composite, RowsStayFinite) {
  constexpr std::size_t count = 35;
  std::vector<float> airlight(3 * count, 1.0f);
  const std::vector<float> transmittance(3 * count, 0.5f);
  const std::vector<float> depth(count, 1.0f);
  std::vector<glm::vec3> behind(count, glm::vec3(2.0f));
  for (const std::size_t i : {std::size_t{3}, count - 1}) {
    airlight[3 * i] = std::numeric_limits<float>::quiet_NaN();
    airlight[3 * i + 1] = -5.0f;
    behind[i].b = infinite;
  }
  std::vector<float> beauty(4 * count);
  composite_row({airlight, transmittance, depth}, behind, beauty);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_odd = i == 3 || i + 1 == count;
    EXPECT_EQ(beauty[4 * i], is_odd ? 0.0f : 2.0f) << i;
    EXPECT_EQ(beauty[4 * i + 1], is_odd ? 0.0f : 2.0f) << i;
    EXPECT_EQ(beauty[4 * i + 2], is_odd ? max_radiance : 2.0f) << i;
  }
}

// Reflection of spherical harmonics in single precision against the plain version.

ShMaterial shiny(double exponent) {
  Material material;
  material.type = Material::Type::phong;
  material.reflectance = {0.4, 0.2, 0.1};
  material.specular = {0.3, 0.5, 0.2};
  material.exponent = exponent;
  return {material, sh_max_bands};
}

// Normals and directions to the eye: any, along the axes, and along each other.
std::unique_ptr<SurfacePoints> points() {
  auto points = std::make_unique<SurfacePoints>();
  points->count = Tiles::pixels;
  Random random(4);
  for (std::size_t k = 0; k < points->count; ++k) {
    glm::dvec3 n = glm::normalize(random.point(1.0));
    glm::dvec3 to_eye = glm::normalize(random.point(1.0));
    if (k % 8 == 1) n = {0, 0, k % 16 == 1 ? 1 : -1};
    if (k % 8 == 2) to_eye = n;
    if (k % 8 == 3) n = {0, k % 16 == 3 ? 1 : -1, 0};
    if (k % 8 == 4) n = glm::normalize(glm::dvec3(1e-5, 1e-5, 1.0));
    if (glm::dot(n, to_eye) < 0.0) to_eye -= 2.0 * glm::dot(n, to_eye) * n;
    points->normal.set(k, glm::vec3(n));
    points->to_eye.set(k, glm::vec3(to_eye));
  }
  return points;
}

TEST(ReflectionKernel, MatchesTheScalarVersion) {
  for (const double exponent : {1.0, 30.0}) {
    for (const int order : {1, 4, 6}) {
      const ShMaterial material = shiny(exponent);
      const auto surface_points = points();
      auto light = std::make_unique<IncidentLight>();
      std::vector<ShVector<glm::dvec3>> lights;
      Random random(9);
      for (std::size_t k = 0; k < surface_points->count; ++k) {
        ShVector<glm::dvec3> all(sh_max_bands);
        ShVector<glm::dvec3> given(order);
        for (std::size_t i = 0; i < given.size(); ++i) all[i] = given[i] = random.point(1.0);
        light->add(k, given);
        lights.push_back(all);
      }
      PointRadiance outgoing;
      reflect(*surface_points, material.table(), *light, outgoing);
      for (std::size_t k = 0; k < surface_points->count; ++k) {
        const glm::dvec3 exact = material.unshadowed(
            lights[k], glm::normalize(surface_points->normal[k]), surface_points->to_eye[k]);
        // The light's coefficients are about 1. The frame of an eye along the normal is any.
        if (k % 8 == 2) continue;
        EXPECT_NEAR(outgoing.r[k], exact.r, 2e-5) << k;
        EXPECT_NEAR(outgoing.g[k], exact.g, 2e-5) << k;
        EXPECT_NEAR(outgoing.b[k], exact.b, 2e-5) << k;
      }
    }
  }
}

// Mixes the light at the corners of triangles, or nothing; of so many points that
// the last vector is not whole.
TEST(ReflectionKernel, MixesTheLightOfCorners) {
  const ShMaterial material = shiny(30.0);
  const auto surface_points = points();
  surface_points->count = 71;
  constexpr std::size_t size = sh_size(4);
  Random random(11);
  std::vector<glm::vec3> corners(3 * size * surface_points->count);
  for (glm::vec3& c : corners) c = glm::vec3(random.point(1.0));
  const glm::vec3 weights(0.5f, 0.2f, 0.3f);
  std::vector<MixedLight> mixed(surface_points->count);
  auto light = std::make_unique<IncidentLight>();
  for (std::size_t k = 0; k < surface_points->count; ++k) {
    if (k % 5 == 3) continue;
    mixed[k].weights = weights;
    for (std::size_t c = 0; c < 3; ++c) {
      mixed[k].corners[c] = &corners[(3 * k + c) * size];
      for (std::size_t i = 0; i < size; ++i) {
        light->add(k, i, weights[static_cast<int>(c)] * mixed[k].corners[c][i]);
      }
    }
  }
  PointRadiance expected;
  PointRadiance outgoing;
  reflect(*surface_points, material.table(), *light, expected);
  reflect(*surface_points, material.table(), mixed, size, outgoing);
  for (std::size_t k = 0; k < surface_points->count; ++k) {
    EXPECT_NEAR(outgoing.r[k], expected.r[k], 2e-6) << k;
    EXPECT_NEAR(outgoing.b[k], expected.b[k], 2e-6) << k;
    EXPECT_EQ(k % 5 == 3, outgoing.g[k] == 0.0f) << k;
  }
}

}  // namespace

}  // namespace brume
