#include "core/authoring/fog_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/authoring/mirror.h"
#include "core/authoring/paintbrush.h"

namespace brume {
namespace {

double density_of(const std::vector<Gaussian>& gaussians, const glm::dvec3& point) {
  double sum = 0.0;
  for (const Gaussian& g : gaussians) {
    const double d = glm::distance(point, g.center) / g.radius;
    sum += g.density * std::exp(-d * d);
  }
  return sum;
}

// The integral of the density over all space.
double total_mass(const std::vector<Gaussian>& gaussians) {
  double sum = 0.0;
  for (const Gaussian& g : gaussians) {
    sum += g.density * std::pow(std::numbers::pi, 1.5) * std::pow(g.radius, 3.0);
  }
  return sum;
}

TEST(FogShapes, ABoxIsEvenInsideAndHasItsMass) {
  FogShape box;
  box.center = {1.0, 2.0, 3.0};
  box.size = {4.0, 2.0, 3.0};
  box.density = 0.7;
  box.spacing = 0.2;
  const auto gaussians = fill(box);
  EXPECT_EQ(static_cast<double>(gaussians.size()), cell_count(box));
  for (const glm::dvec3 offset : {glm::dvec3(0.0), glm::dvec3(0.53, 0.11, -0.37)}) {
    EXPECT_NEAR(density_of(gaussians, box.center + offset), 0.7, 0.007);
  }
  EXPECT_NEAR(total_mass(gaussians), 0.7 * 24.0, 1e-6);
}

TEST(FogShapes, ASphereStaysInside) {
  FogShape sphere;
  sphere.kind = FogShape::Kind::sphere;
  sphere.size = glm::dvec3(2.0);
  sphere.spacing = 0.1;
  sphere.density = 0.5;
  const auto gaussians = fill(sphere);
  for (const Gaussian& g : gaussians) EXPECT_LE(glm::length(g.center), 1.0);
  EXPECT_NEAR(total_mass(gaussians), 0.5 * 4.0 / 3.0 * std::numbers::pi, 0.1);
}

TEST(FogShapes, HeightFogFallsByE) {
  FogShape fog;
  fog.kind = FogShape::Kind::height;
  fog.size = {4.0, 1.0, 4.0};
  fog.spacing = 0.1;
  fog.density = 0.4;
  const auto gaussians = fill(fog);
  const double low = density_of(gaussians, {0.0, 0.5, 0.0});
  const double high = density_of(gaussians, {0.0, 1.5, 0.0});
  EXPECT_NEAR(low / high, std::numbers::e, 0.03);
  EXPECT_NEAR(low, 0.4 * std::exp(-0.5), 0.01);
}

TEST(FogShapes, JitterStaysWithinCells) {
  FogShape box;
  box.size = glm::dvec3(1.0);
  box.spacing = 0.25;
  box.jitter = 1.0;
  const auto gaussians = fill(box);
  EXPECT_EQ(gaussians, fill(box));
  for (const Gaussian& g : gaussians) {
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(g.center[k]), 0.5);
  }
  box.seed = 2;
  EXPECT_NE(gaussians, fill(box));
}

TEST(FogShapes, ALayerFollowsTheGround) {
  FogShape layer;
  layer.size = {8.0, 0.5, 8.0};
  layer.spacing = 1.0;
  const auto gaussians = lay_on_ground(layer, [](double x, double) -> std::optional<double> {
    if (x < 0.0) return std::nullopt;
    return 2.0 * x;
  });
  EXPECT_EQ(gaussians.size(), 32u);
  for (const Gaussian& g : gaussians) {
    EXPECT_GE(g.center.x, 0.0);
    EXPECT_NEAR(g.center.y, 2.0 * g.center.x + 0.28, 1e-12);
  }
}

TEST(FogShapes, FlatGaussiansAreFewerForTheSameFog) {
  FogShape box;
  box.size = {6.0, 2.0, 6.0};
  box.density = 0.7;
  box.spacing = 0.2;
  box.flatness = 3.0;
  const auto gaussians = fill(box);
  EXPECT_EQ(gaussians.size(), 1000u);
  EXPECT_EQ(cell_count(box), 1000.0);
  double mass = 0.0;
  for (const Gaussian& g : gaussians) {
    mass += g.density * std::pow(std::sqrt(std::numbers::pi) * g.mean_radius(), 3);
  }
  EXPECT_NEAR(mass, 0.7 * 72.0, 1e-6);
  for (const glm::dvec3 at : {glm::dvec3(0.0), glm::dvec3(0.53, 0.11, -0.37)}) {
    double density = 0.0;
    for (const Gaussian& g : gaussians) {
      const glm::dvec3 q = (at - g.center) / glm::dvec3(0.48, 0.16, 0.48);
      density += g.density * std::exp(-glm::dot(q, q));
    }
    EXPECT_NEAR(density, 0.7, 0.01);
  }
}

TEST(FogShapes, FlatLayersLieAlongTheSlope) {
  FogShape layer;
  layer.size = {8.0, 0.5, 8.0};
  layer.spacing = 0.5;
  layer.flatness = 2.0;
  const auto gaussians =
      lay_on_ground(layer, [](double x, double) { return std::optional(0.75 * x); });
  EXPECT_EQ(gaussians.size(), 64u);
  for (const Gaussian& g : gaussians) {
    const glm::dvec3 up = g.shape.rotation * glm::dvec3(0.0, 1.0, 0.0);
    EXPECT_LT(glm::length(up - glm::dvec3(-0.6, 0.8, 0.0)), 1e-12);
  }
}

TEST(FogShapes, AColumnRisesAndWidens) {
  FogColumn column;
  column.foot = {1.0, 0.0, 0.0};
  column.height = 3.0;
  column.lean = {1.0, 0.0, 0.0};
  column.turbulence = 0.0;
  const auto gaussians = rise(column);
  EXPECT_EQ(gaussians.size(), column.count);
  for (std::size_t k = 1; k < gaussians.size(); ++k) {
    EXPECT_GT(gaussians[k].center.y, gaussians[k - 1].center.y);
    EXPECT_GE(gaussians[k].radius, gaussians[k - 1].radius);
    EXPECT_GE(gaussians[k].density, 0.0);
  }
  EXPECT_LE(gaussians.back().center.y, 3.0);
  EXPECT_NEAR(gaussians.back().center.x, 2.0, 0.1);
}

TEST(Mirror, MakesAnImagePerSide) {
  const Gaussian g{{1.0, 2.0, 3.0}, 0.5, 1.0};
  EXPECT_EQ(mirror_images(g, {}).size(), 1u);
  const auto images = mirror_images(g, {{true, false, true}, {0.5, 0.0, 0.0}});
  ASSERT_EQ(images.size(), 4u);
  EXPECT_EQ(images[0], g);
  EXPECT_EQ(images[1].center, glm::dvec3(0.0, 2.0, 3.0));
  EXPECT_EQ(images[3].center, glm::dvec3(0.0, 2.0, -3.0));
}

TEST(PaintStroke, PressureScalesRadiusDensityAndSpacing) {
  Paintbrush brush;
  brush.scatter = 0.0;
  PaintStroke full(brush, 1);
  PaintStroke light(brush, 1);
  full.extend({0.0, 0.0, 0.0});
  light.extend({0.0, 0.0, 0.0}, 0.5, 0.25);
  const auto dense = full.extend({3.0, 0.0, 0.0});
  const auto thin = light.extend({3.0, 0.0, 0.0}, 0.5, 0.25);
  EXPECT_NEAR(static_cast<double>(thin.size()), 2.0 * static_cast<double>(dense.size()), 1.0);
  EXPECT_DOUBLE_EQ(thin[0].radius, 0.5 * brush.radius);
  EXPECT_DOUBLE_EQ(thin[0].density, 0.25 * brush.density);
}

}  // namespace
}  // namespace brume
