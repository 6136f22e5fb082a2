// Metallic-roughness reflection in single precision against the plain version.

#include "render/simd/ggx_kernels.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <memory>

#include "core/scene/materials/brdf.h"
#include "core/scene/materials/ggx_sh.h"
#include "render/simd/reflection_kernels.h"
#include "tests/random.h"

namespace brume {
namespace {

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
