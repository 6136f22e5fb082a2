#include "core/scene/materials/brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/math/quadrature.h"
#include "core/math/sphere_rule.h"
#include "tests/core/scene/from_angles.h"
#include "tests/random.h"

namespace brume {
namespace {

using std::numbers::pi;

Material diffuse(double reflectance) {
  Material material;
  material.reflectance = glm::dvec3(reflectance);
  return material;
}

Material phong(double reflectance, double specular, double exponent) {
  Material material = diffuse(reflectance);
  material.type = Material::Type::phong;
  material.specular = glm::dvec3(specular);
  material.exponent = exponent;
  return material;
}

TEST(Brdf, IsReciprocal) {
  Random random(31);
  const glm::dvec3 n(0, 0, 1);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 wi = from_angles(random.uniform(0, 1.5), random.uniform(0, 6));
    const glm::dvec3 wo = from_angles(random.uniform(0, 1.5), random.uniform(0, 6));
    const Material material = phong(0.3, 0.6, 7.0);
    EXPECT_NEAR(brdf(material, wi, wo, n).x, brdf(material, wo, wi, n).x, 1e-13);
  }
  EXPECT_EQ(brdf(diffuse(0.5), {0, 0, -1}, n, n), glm::dvec3(0.0)) << "light from behind";
  EXPECT_NEAR(brdf(diffuse(0.5), n, n, n).x, 0.5 / pi, 1e-16);
}

TEST(Brdf, HighlightReflectsAllOfItsLightStraightOnAndNeverMore) {
  // A white furnace: at normal incidence the lobe integrates to `specular`.
  for (const double exponent : {0.0, 1.0, 10.0, 300.0}) {
    const Material material = phong(0.0, 1.0, exponent);
    const auto reflected = [&](double theta) {
      const glm::dvec3 wo(0, 0, 1);
      const glm::dvec3 wi = from_angles(theta, 0.0);
      return 2 * pi * std::sin(theta) * std::cos(theta) * brdf(material, wi, wo, wo).x;
    };
    const std::array<double, 3> breakpoints = {0.0, 0.1, 0.5 * pi};
    EXPECT_NEAR(integrate<double>(reflected, breakpoints, 1e-9).value, 1.0, 1e-8) << exponent;
    const BrdfSh table(material, 1);
    for (double c = 0.0; c <= 1.0; c += 0.05) {
      EXPECT_LE(table(c)[0].x * std::sqrt(4 * pi), 1.0 + 1e-3) << exponent << ' ' << c;
    }
  }
}

TEST(BrdfSh, DiffuseIsTheClampedCosine) {
  const BrdfSh table(diffuse(0.6), 6);
  const double lambert[] = {pi, 2 * pi / 3, pi / 4, 0, -pi / 24, 0};
  const ShVector<glm::dvec3> b = table(0.3);
  for (int l = 0; l < 6; ++l) {
    for (int m = -l; m <= l; ++m) {
      const double value = m == 0 ? lambert[l] * std::sqrt((2 * l + 1) / (4 * pi)) * 0.6 / pi : 0.0;
      EXPECT_NEAR(b[sh_index(l, m)].y, value, 1e-15) << l << ' ' << m;
    }
  }
  // A constant environment of radiance 1 leaves as the reflectance.
  ShVector<double> sky(6);
  sky[0] = std::sqrt(4 * pi);
  EXPECT_NEAR(sh_dot(b, sky).z, 0.6, 1e-15);
}

TEST(BrdfSh, QuadratureFindsTheDiffuseSurfaceToo) {
  // A highlight of exponent 0 is diffuse within the half space of the lobe; seen straight on that
  // is all of the upper one.
  const ShVector<glm::dvec3> flat = BrdfSh(phong(0.0, 1.0, 0.0), 6)(1.0);
  const ShVector<glm::dvec3> lambert = BrdfSh(diffuse(1.0), 6)(1.0);
  for (std::size_t i = 0; i < flat.size(); ++i) EXPECT_NEAR(flat[i].x, lambert[i].x, 1e-4) << i;
}

TEST(BrdfSh, MatchesTheProjectionOfTheBrdf) {
  for (const double exponent : {3.0, 30.0}) {
    const Material material = phong(0.2, 0.7, exponent);
    const BrdfSh table(material, 6);
    for (const double theta : {0.0, 0.4, 1.1, 1.45}) {
      const glm::dvec3 wo = from_angles(theta, 0.0);
      ShVector<double> reference(6);
      // A fine product rule; the horizon makes its error 1 / 200 squared.
      for (const SphereNode& node : sphere_rule(400)) {
        if (!(node.direction.z > 0.0)) continue;
        const double f = brdf(material, node.direction, wo, {0, 0, 1}).x * node.direction.z;
        const ShVector<double> y = sh_basis(6, node.direction);
        for (std::size_t i = 0; i < reference.size(); ++i) reference[i] += node.weight * f * y[i];
      }
      const ShVector<glm::dvec3> got = table(std::cos(theta));
      for (std::size_t i = 0; i < reference.size(); ++i) {
        EXPECT_NEAR(got[i].x, reference[i], 2e-3) << exponent << ' ' << theta << ' ' << i;
      }
    }
  }
}

TEST(BrdfSh, MirrorApproachesADeltaFunction) {
  // The sharpest highlights: all light, from the mirrored direction.
  const BrdfSh table(phong(0.0, 1.0, 1e12), 6);
  const double theta = 0.7;
  const ShVector<double> delta = sh_basis(6, from_angles(theta, pi));
  const ShVector<glm::dvec3> b = table(std::cos(theta));
  for (std::size_t i = 0; i < b.size(); ++i) {
    EXPECT_NEAR(b[i].x, delta[i] * std::cos(theta), 5e-3) << i;
  }
}

TEST(SurfaceFrame, AlignsWithNormalAndEye) {
  Random random(33);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 n = glm::normalize(random.point(1.0));
    const glm::dvec3 wo = i == 0 ? n : glm::normalize(random.point(1.0));
    const glm::dquat frame = surface_frame(n, wo);
    EXPECT_NEAR(glm::length(frame * glm::dvec3(0, 0, 1) - n), 0.0, 1e-14);
    const glm::dvec3 local = glm::conjugate(frame) * wo;
    EXPECT_NEAR(local.y, 0.0, 1e-14);
    EXPECT_GE(local.x, -1e-14);
  }
}

Material metallic_roughness(double base_color, double metallic, double roughness) {
  Material material;
  material.type = Material::Type::metallic_roughness;
  material.metallic_roughness.base_color = glm::dvec3(base_color);
  material.metallic_roughness.metallic = metallic;
  material.metallic_roughness.roughness = roughness;
  return material;
}

TEST(MeanReflectance, OfADiffuseMaterialIsItsReflectance) {
  Material material;
  material.reflectance = {0.2, 0.5, 0.8};
  EXPECT_EQ(mean_reflectance(material), material.reflectance);
}

// Schlick's term over a cosine: f0 + (1 - f0) / 21. A rule over directions met its own mirror
// images here and found all light reflected.
TEST(MeanReflectance, SmoothMaterialsReflectWhatFresnelsTermSays) {
  for (const double roughness : {0.0, 0.05, 0.1}) {
    EXPECT_NEAR(mean_reflectance(metallic_roughness(0.0, 0.0, roughness)).x, 0.04 + 0.96 / 21.0,
                0.003)
        << roughness;
    EXPECT_NEAR(mean_reflectance(metallic_roughness(0.5, 1.0, roughness)).y, 0.5 + 0.5 / 21.0, 0.01)
        << roughness;
  }
}

// At roughness 1 the lost light of several reflections is known: 0.55 is left of a white metal.
TEST(MeanReflectance, RoughMetalsLoseLight) {
  const double rough = mean_reflectance(metallic_roughness(1.0, 1.0, 1.0)).x;
  EXPECT_GT(rough, 0.4);
  EXPECT_LT(rough, 0.7);
}

TEST(MeanReflectance, NarrowPhongHighlightsAreFound) {
  Material material;
  material.type = Material::Type::phong;
  material.reflectance = glm::dvec3(0.1);
  material.specular = glm::dvec3(0.3);
  for (const double exponent : {1e2, 1e3, 1e4}) {
    material.exponent = exponent;
    // The lobe's integral times its cosine, 2/3 of it over all angles.
    EXPECT_NEAR(mean_reflectance(material).x, 0.1 + 0.3 * 2.0 / 3.0, 0.02) << exponent;
  }
}

}  // namespace

}  // namespace brume
