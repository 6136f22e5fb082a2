#include "core/scene/lights/area_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/basis.h"

namespace brume {
namespace {

using std::numbers::pi;

const glm::dvec3 middle(0.3, 1.0, -0.2);

AreaLight rectangle(bool two_sided = false) {
  return light::Rectangle{.direction = {0.3, -1.0, 0.2},
                          .up = {0.1, 0.2, 1.0},
                          .width = 1.4,
                          .height = 0.6,
                          .two_sided = two_sided};
}
AreaLight disk(bool two_sided = false) {
  return light::Disk{{0.3, -1.0, 0.2}, 0.5, two_sided};
}
AreaLight sphere(bool two_sided = false) {
  return light::Sphere{0.5, two_sided};
}

// The irradiance by rays from x, evenly over the solid angle.
double by_rays(const AreaLight& area, const glm::dvec3& x, const glm::dvec3& normal) {
  constexpr int ray_rows = 1500;
  const auto [u, v] = make_basis(normal);
  double sum = 0.0;
  for (int i = 0; i < ray_rows; ++i) {
    const double cosine = (i + 0.5) / ray_rows;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    for (int k = 0; k < ray_rows; ++k) {
      const double turn = 2.0 * pi * (k + 0.5) / ray_rows;
      const glm::dvec3 w = sine * std::cos(turn) * u + sine * std::sin(turn) * v + cosine * normal;
      if (hit_area(area, middle, x, w)) sum += cosine;
    }
  }
  return 2.0 * pi * sum / (ray_rows * ray_rows);
}

struct Receiver {
  glm::dvec3 position, normal;
};
// Below it, beside it, behind it, and where the horizon cuts it.
const Receiver receivers[] = {
    {{0.2, 0.0, 0.1}, {0.1, 1.0, 0.2}},   {{1.5, 0.4, 0.3}, {-1.0, 0.1, 0.0}},
    {{0.3, 0.45, -0.2}, {1.0, 0.1, 0.3}}, {{0.4, 0.3, 0.2}, {0.9, 0.2, -0.4}},
    {{0.3, 2.0, 0.0}, {0.1, -1.0, 0.0}},  {{-0.6, 0.9, 0.5}, {0.2, -0.8, -0.6}}};

TEST(AreaLights, IrradianceIsThatOfRays) {
  for (const AreaLight& area : {rectangle(), disk(), sphere(), rectangle(true), disk(true)}) {
    for (const auto& [position, direction] : receivers) {
      const glm::dvec3 normal = glm::normalize(direction);
      const double expected = by_rays(area, position, normal);
      EXPECT_NEAR(area_irradiance(area, middle, position, normal), expected, 1e-3 * expected + 3e-5)
          << "kind " << area.index() << " from " << position.x << ", " << position.y;
    }
  }
}

TEST(AreaLights, SpheresShineWithinWhereTwoSided) {
  const glm::dvec3 within = middle + glm::dvec3(0.1, 0.2, 0.0);
  EXPECT_EQ(area_irradiance(sphere(), middle, within, {0, 1, 0}), 0.0);
  EXPECT_NEAR(area_irradiance(sphere(true), middle, within, {0, 1, 0}), pi, 1e-12);
  EXPECT_FALSE(hit_area(sphere(), middle, within, {0, 1, 0}));
  EXPECT_TRUE(hit_area(sphere(true), middle, within, {0, 1, 0}));
}

TEST(AreaLights, BacksShineWhereTwoSided) {
  const glm::dvec3 above = middle + glm::dvec3(0.0, 1.0, 0.0);
  for (const auto& [one, both] :
       {std::pair(rectangle(), rectangle(true)), std::pair(disk(), disk(true))}) {
    EXPECT_EQ(area_irradiance(one, middle, above, {0, -1, 0}), 0.0);
    EXPECT_GT(area_irradiance(both, middle, above, {0, -1, 0}), 0.1);
    EXPECT_FALSE(hit_area(one, middle, above, {0, -1, 0}));
    EXPECT_NEAR(hit_area(both, middle, above, {0, -1, 0})->distance, 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace brume
