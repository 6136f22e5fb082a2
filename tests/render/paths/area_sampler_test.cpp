#include "render/paths/area_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/lights/point_lights.h"

namespace brume {
namespace {

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
