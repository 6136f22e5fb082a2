// Reflection of spherical harmonics in single precision against the plain version.

#include "render/simd/reflection_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "render/transfer/sh_material.h"
#include "tests/random.h"

namespace brume {
namespace {

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
