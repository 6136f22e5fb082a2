// Area lights at surfaces in single precision against the plain version.

#include "render/simd/area_kernels.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <memory>

#include "core/scene/lights/area_lights.h"
#include "tests/random.h"

namespace brume {
namespace {

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

}  // namespace
}  // namespace brume
