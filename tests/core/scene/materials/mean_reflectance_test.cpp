#include "core/scene/materials/mean_reflectance.h"

#include <gtest/gtest.h>

namespace brume {
namespace {

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
