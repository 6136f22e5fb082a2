// Each sampler draws from the density that it says.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <vector>

#include "core/scene/lights/environment.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/materials/brdf.h"
#include "core/scene/materials/measured_brdf.h"
#include "render/paths/area_sampler.h"
#include "render/paths/direction_sampling.h"
#include "render/paths/environment_sampler.h"
#include "render/paths/material_sampler.h"
#include "render/paths/path_sums.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

using std::numbers::pi;

PathRandom random_of(int i) {
  return {7, 0, static_cast<std::uint64_t>(i), 0};
}

glm::dvec3 uniform_direction(PathRandom& random) {
  return direction_around({0, 0, 1}, 2.0 * random.uniform() - 1.0, random);
}

struct Mean {
  double value = 0.0;
  double error = 0.0;
};
Mean mean_of(int count, const std::function<double(PathRandom&)>& sample) {
  double sum = 0.0;
  double square = 0.0;
  for (int i = 0; i < count; ++i) {
    PathRandom random = random_of(i);
    const double x = sample(random);
    sum += x;
    square += x * x;
  }
  const double mean = sum / count;
  return {mean, std::sqrt((square / count - mean * mean) / (count - 1))};
}

void expect_equal(const Mean& a, const Mean& b) {
  EXPECT_NEAR(a.value, b.value, 4.0 * std::hypot(a.error, b.error) + 1e-12);
}

// A sky with a sun, and black below.
Environment sunny() {
  auto map = std::make_shared<RadianceMap>(RadianceMap{64, 32, {}});
  for (int i = 0; i < 64 * 32; ++i) {
    const glm::dvec3 d = map_direction(*map, {i % 64 + 0.5, i / 64 + 0.5});
    map->pixels.emplace_back(d.y > 0.0 ? glm::vec3(0.2, 0.4, 1.0) : glm::vec3(0.0));
  }
  map->pixels[8 * 64 + 20] = glm::vec3(500.0);
  Environment environment;
  environment.map = map;
  environment.intensity = 2.0;
  environment.rotation = 40.0;
  return environment;
}

TEST(PathRandom, DependsOnAllThatNamesAPath) {
  const std::uint64_t bits = PathRandom(1, 2, 3, 4).bits();
  EXPECT_EQ(PathRandom(1, 2, 3, 4).bits(), bits);
  EXPECT_NE(PathRandom(0, 2, 3, 4).bits(), bits);
  EXPECT_NE(PathRandom(1, 3, 3, 4).bits(), bits);
  EXPECT_NE(PathRandom(1, 2, 4, 4).bits(), bits);
  EXPECT_NE(PathRandom(1, 2, 3, 5).bits(), bits);
  EXPECT_NE(PathRandom(1, 3, 2, 4).bits(), PathRandom(1, 2, 3, 4).bits());
}

TEST(StratifiedPair, CoversEachEighthOnceAndIsUniform) {
  std::array<int, 16> counts{};
  for (int block = 0; block < 2000; ++block) {
    const PathRandom of_block(1, 5, static_cast<std::uint64_t>(block), 0);
    std::array<unsigned, 2> seen{};
    for (unsigned k = 0; k < path_block; ++k) {
      PathRandom random = random_of(block * path_block + static_cast<int>(k));
      const StratifiedPair pair(of_block, k, random);
      seen[0] |= 1u << static_cast<unsigned>(8.0 * pair.first);
      seen[1] |= 1u << static_cast<unsigned>(8.0 * pair.second);
      // The first sample of a block alone is uniform too.
      if (k == 0) ++counts[static_cast<std::size_t>(16.0 * pair.first)];
    }
    ASSERT_EQ(seen[0], 0xffu);
    ASSERT_EQ(seen[1], 0xffu);
  }
  for (const int count : counts) EXPECT_NEAR(count, 125, 4.0 * std::sqrt(125.0));
}

TEST(PathSums, TellTheVarianceOfTheirMean) {
  const glm::dvec3 channels(1.0, 0.0, 1.0);
  for (const int n : {2, 5, 16, 43}) {
    double square = 0.0;
    double claimed = 0.0;
    constexpr int runs = 4000;
    for (int run = 0; run < runs; ++run) {
      PathRandom random = random_of(run);
      PathSums sums;
      for (int k = 0; k < n; ++k) {
        sums.add(k, {random.uniform(), 100.0 * random.uniform(), 3.0}, channels);
      }
      square += std::pow(sums.mean(n).x - 0.5, 2) / runs;
      claimed += sums.variance(n, channels) / runs;
    }
    // 4000 runs estimate it to 2.2%.
    EXPECT_NEAR(claimed / square, 1.0, 0.1) << n;
  }
  PathSums one;
  one.add(0, glm::dvec3(5.0), channels);
  EXPECT_EQ(one.variance(1, channels), 0.0);
}

TEST(EnvironmentSampler, DrawsFromItsDensity) {
  const EnvironmentSampler sampler(sunny());
  ASSERT_FALSE(sampler.empty());
  // The integrals of the density and of the radiance, against uniform directions.
  const Mean one = mean_of(200'000, [&](PathRandom& random) {
    return 4.0 * pi * sampler.pdf(uniform_direction(random));
  });
  EXPECT_NEAR(one.value, 1.0, 4.0 * one.error);
  const Mean uniform = mean_of(400'000, [&](PathRandom& random) {
    return 4.0 * pi * sampler.radiance(uniform_direction(random)).x;
  });
  const Mean sampled = mean_of(20'000, [&](PathRandom& random) {
    const glm::dvec3 w = sampler.sample(random);
    return sampler.radiance(w).x / sampler.pdf(w);
  });
  expect_equal(uniform, sampled);
  EXPECT_LT(sampled.error, 0.02 * sampled.value) << "the sun is sampled";
  EXPECT_EQ(sampler.radiance({0.3, 0.5, 0.2}),
            environment_radiance(sampler.environment(), {0.3, 0.5, 0.2}));
}

TEST(EnvironmentSampler, MissesNoRadiance) {
  auto map = std::make_shared<RadianceMap>(RadianceMap{8, 4, std::vector(32, glm::vec3(0.0))});
  for (const std::size_t lit : {0u, 7u, 12u, 31u}) {
    RadianceMap one = *map;
    one.pixels[lit] = glm::vec3(1.0);
    Environment environment;
    environment.map = std::make_shared<const RadianceMap>(one);
    const EnvironmentSampler sampler(environment);
    for (int i = 0; i < 20'000; ++i) {
      PathRandom random = random_of(i);
      const glm::dvec3 w = uniform_direction(random);
      if (sampler.radiance(w).x > 1e-9) {
        ASSERT_GT(sampler.pdf(w), 0.0);
      }
    }
  }
}

TEST(EnvironmentSampler, SharesCellsInLargeMaps) {
  auto map = std::make_shared<RadianceMap>(RadianceMap{3001, 1500, {}});
  map->pixels.assign(3001 * 1500, glm::vec3(1.0));
  map->pixels[700 * 3001 + 3000] = glm::vec3(1e6);
  Environment environment;
  environment.map = map;
  const EnvironmentSampler sampler(environment);
  const Mean inverse = mean_of(50'000, [&](PathRandom& random) {
    const glm::dvec3 w = sampler.sample(random);
    return (sampler.radiance(w).x < 2.0 ? 1.0 : 0.0) / sampler.pdf(w);
  });
  EXPECT_NEAR(inverse.value, 4.0 * pi, 4.0 * inverse.error + 1e-4);
}

TEST(EnvironmentSampler, IsEmptyWhereNothingShines) {
  Environment environment;
  environment.map = constant_sky(0.0f);
  EXPECT_TRUE(EnvironmentSampler(environment).empty());
  environment.map = constant_sky(1.0f);
  environment.intensity = 0.0;
  EXPECT_TRUE(EnvironmentSampler(environment).empty());
}

TEST(HenyeyGreenstein, IsSampledExactly) {
  for (const double g : {-0.95, -0.5, 0.0, 1e-5, 0.3, 0.95}) {
    const Mean cosine = mean_of(50'000, [&](PathRandom& random) {
      return henyey_greenstein_quantile(random.uniform(), g);
    });
    EXPECT_NEAR(cosine.value, g, 4.0 * cosine.error + 1e-12) << g;
    const Mean second = mean_of(50'000, [&](PathRandom& random) {
      const double c = henyey_greenstein_quantile(random.uniform(), g);
      return 0.5 * (3.0 * c * c - 1.0);  // whose mean is g^2
    });
    EXPECT_NEAR(second.value, g * g, 4.0 * second.error + 1e-12) << g;
  }
}

Material measured_material() {
  // A highlight over a base.
  std::vector<glm::vec3> values;
  for (int h = 0; h < MeasuredBrdf::theta_h_cells; ++h) {
    const double x = (h + 0.5) / MeasuredBrdf::theta_h_cells;
    const double cosine = std::cos(0.5 * pi * x * x);
    const auto value = static_cast<float>(0.1 + 5.0 * std::pow(cosine, 60.0));
    values.insert(values.end(),
                  std::size_t{MeasuredBrdf::theta_d_cells} * MeasuredBrdf::phi_d_cells,
                  glm::vec3(value));
  }
  Material material;
  material.type = Material::Type::measured;
  material.measured = std::make_shared<const MeasuredBrdf>(std::move(values));
  return material;
}

TEST(MaterialSampler, DrawsFromItsDensity) {
  Material phong;
  phong.type = Material::Type::phong;
  phong.specular = glm::dvec3(0.4);
  phong.exponent = 30.0;
  Material mirror = phong;
  mirror.reflectance = glm::dvec3(0.0);
  for (const Material& material : {Material{}, phong, mirror, measured_material()}) {
    const MaterialSampler sampler(material);
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.2, 0.1, 1.0));
    for (const double tilt : {0.1, 1.2, 4.0, -20.0}) {  // the last a little behind
      const glm::dvec3 wo = glm::normalize(glm::dvec3(tilt, 0.3, 1.0));
      const Mean one = mean_of(60'000, [&](PathRandom& random) {
        return 4.0 * pi * sampler.pdf(uniform_direction(random), n, wo);
      });
      EXPECT_NEAR(one.value, 1.0, 4.0 * one.error + 1e-3);
      const auto value = [&](const glm::dvec3& w) {
        return brdf(material, w, wo, n).x * std::max(0.0, glm::dot(w, n));
      };
      const Mean uniform = mean_of(
          60'000, [&](PathRandom& random) { return 4.0 * pi * value(uniform_direction(random)); });
      const Mean sampled = mean_of(10'000, [&](PathRandom& random) {
        const glm::dvec3 w = sampler.sample(n, wo, random);
        const double pdf = sampler.pdf(w, n, wo);
        return pdf > 0.0 ? value(w) / pdf : 0.0;
      });
      expect_equal(uniform, sampled);
    }
  }
}

using std::numbers::pi;

const glm::dvec3 center(1.0, 2.0, 3.0);

enum class Shape { rectangle, disk, sphere };

AreaLight facing_down(Shape shape, bool two_sided = false) {
  const glm::dvec3 down(0.0, -2.0, 0.0);
  if (shape == Shape::disk) return light::Disk{down, 0.5, two_sided};
  if (shape == Shape::sphere) return light::Sphere{0.5, two_sided};
  return light::Rectangle{down, {1.0, 0.0, 1.0}, 1.2, 0.7, two_sided};
}

constexpr int drawn_points = 40'000;

// The solid angle at x, from points drawn for x.
double seen_solid_angle(const AreaLight& area, const glm::dvec3& x) {
  const AreaSampler sampler(area, center);
  PathRandom random(1, 2, 3, 4);
  double sum = 0.0;
  for (int i = 0; i < drawn_points; ++i) {
    const AreaSampler::SeenPoint seen = sampler.seen_from(x, random);
    const glm::dvec3 q = seen.position - x;
    if (seen.factor > 0.0) sum += seen.factor / glm::dot(q, q);
  }
  return sum / drawn_points * surface_area(area);
}

// The same from points of the whole surface.
double surface_solid_angle(const AreaLight& area, const glm::dvec3& x) {
  const AreaSampler sampler(area, center);
  PathRandom random(5, 6, 7, 8);
  double sum = 0.0;
  for (int i = 0; i < drawn_points; ++i) {
    const AreaSampler::Point point = sampler.on_surface(random);
    const glm::dvec3 q = point.position - x;
    sum += sampler.cosine(point, x) / glm::dot(q, q);
  }
  return sum / drawn_points * surface_area(area);
}

// The solid angle of a disk from its axis, or of a sphere from outside.
double disk_solid_angle(double radius, double distance) {
  return 2.0 * pi * (1.0 - distance / std::hypot(distance, radius));
}
double sphere_solid_angle(double radius, double distance) {
  const double sine = radius / distance;
  return 2.0 * pi * (1.0 - std::sqrt(1.0 - sine * sine));
}
// The solid angle of a rectangle from its axis.
double rectangle_solid_angle(double width, double height, double distance) {
  const double a = 0.5 * width / distance;
  const double b = 0.5 * height / distance;
  return 4.0 * std::asin(a * b / std::sqrt((1.0 + a * a) * (1.0 + b * b)));
}

TEST(AreaSampler, FillsTheSolidAngle) {
  for (const double distance : {0.001, 0.05, 0.6, 3.0, 1000.0}) {
    const glm::dvec3 below = center - glm::dvec3(0.0, distance, 0.0);
    const double rectangle = rectangle_solid_angle(1.2, 0.7, distance);
    EXPECT_NEAR(seen_solid_angle(facing_down(Shape::rectangle), below), rectangle,
                1e-6 * rectangle);
    // A fifth of the square around the disk is outside it: noise.
    const double disk = disk_solid_angle(0.5, distance);
    EXPECT_NEAR(seen_solid_angle(facing_down(Shape::disk), below), disk, 0.01 * disk);
    const double sphere = sphere_solid_angle(0.5, 0.5 + distance);
    EXPECT_NEAR(seen_solid_angle(facing_down(Shape::sphere), below - glm::dvec3(0.0, 0.5, 0.0)),
                sphere, 1e-5 * sphere)
        << distance;
  }
}

// Drawn for a point and over the surface, points send it the same.
TEST(AreaSampler, AgreesWithTheWholeSurface) {
  for (const Shape shape : {Shape::rectangle, Shape::disk, Shape::sphere}) {
    for (const bool two_sided : {false, true}) {
      const AreaLight area = facing_down(shape, two_sided);
      for (const glm::dvec3& offset :
           {glm::dvec3(0.3, -0.6, 0.2), {0.8, -0.3, -0.9}, {0.1, 0.3, 0.0}, {2.0, 1.0, 3.0}}) {
        const double expected = surface_solid_angle(area, center + offset);
        EXPECT_NEAR(seen_solid_angle(area, center + offset), expected, 0.03 * expected)
            << static_cast<int>(shape) << " sides " << 1 + two_sided << " at " << offset.x;
      }
    }
  }
}

// A point is found with the density that its factor is one by.
TEST(AreaSampler, KnowsTheDensityOfItsPoints) {
  for (const Shape shape : {Shape::rectangle, Shape::disk, Shape::sphere}) {
    const AreaLight area = facing_down(shape);
    const AreaSampler sampler(area, center);
    PathRandom random(9, 10, 11, 12);
    for (const glm::dvec3& offset :
         {glm::dvec3(0.1, -0.2, 0.2), {0.3, -0.6, 0.2}, {2.0, -1.0, 3.0}, {0.0, -2000.0, 1.0}}) {
      for (int i = 0; i < 10; ++i) {
        const AreaSampler::SeenPoint seen = sampler.seen_from(center + offset, random);
        if (!(seen.factor > 0.0)) continue;
        const glm::dvec3 q = seen.position - center - offset;
        const double density = glm::dot(q, q) / (seen.factor * surface_area(area));
        EXPECT_NEAR(sampler.direction_pdf(center + offset, seen.position), density, 1e-6 * density);
      }
    }
  }
}

TEST(AreaSampler, ShinesToItsFrontOrToBothSides) {
  const glm::dvec3 above = center + glm::dvec3(0.1, 0.3, 0.0);
  for (const Shape shape : {Shape::rectangle, Shape::disk}) {
    EXPECT_EQ(seen_solid_angle(facing_down(shape), above), 0.0);
    EXPECT_FALSE(AreaSampler(facing_down(shape), center).shines_to(above));
    EXPECT_GT(seen_solid_angle(facing_down(shape, true), above), 1.0);
  }
  // Within a sphere all directions are lit, or none.
  EXPECT_EQ(seen_solid_angle(facing_down(Shape::sphere), above), 0.0);
  EXPECT_NEAR(seen_solid_angle(facing_down(Shape::sphere, true), above), 4.0 * pi, 1e-9);
}

}  // namespace

}  // namespace brume
