#include "core/medium/splat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "tests/random.h"

namespace brume {
namespace {

double integral(const Gaussian& g) {
  return g.density * std::pow(std::sqrt(std::numbers::pi) * g.radius, 3.0);
}

// The mean of (x - center) (x - center)^T over all balls, in the splat's own axes.
glm::dmat3 second_moments(const Splat& splat, const std::vector<Gaussian>& spheres) {
  glm::dmat3 sum(0.0);
  double all = 0.0;
  for (const Gaussian& g : spheres) {
    const glm::dvec3 d = glm::inverse(splat.rotation) * (g.center - splat.center);
    sum += integral(g) * (glm::outerProduct(d, d) + glm::dmat3(0.5 * g.radius * g.radius));
    all += integral(g);
  }
  return sum / all;
}

TEST(Splat, LongOnesBecomeRowsOfTheirMassAndExtents) {
  Random random(1);
  struct Case {
    glm::dvec3 deviations;
    std::size_t count;
    glm::dvec3 extents;  // of what they become
  };
  const double widest = std::sqrt(11.0 / 3.0);  // of three balls, two deviations apart
  for (const Case& c :
       {Case{{0.7, 0.3, 0.3}, 3, {0.7, 0.7 / widest, 0.7 / widest}},
        Case{{0.3, 0.5, 0.3}, 3, {0.3, 0.5, 0.3}}, Case{{0.3, 0.3, 0.42}, 2, {0.3, 0.3, 0.42}},
        Case{{1.0, 1.0, 0.01}, 9, {1.0, 1.0, 1.0 / widest}},
        Case{{0.8, 0.5, 0.5}, 3, {0.8, 0.5, 0.5}}}) {
    Splat splat;
    splat.center = random.point(5.0);
    splat.deviations = c.deviations;
    const glm::dvec3 axis = random.point(1.0);
    splat.rotation = glm::normalize(glm::dquat(random.uniform(-1.0, 1.0), axis.x, axis.y, axis.z));
    splat.depth = 0.7;
    const std::vector<Gaussian> spheres = sphere_approximation(splat);
    ASSERT_EQ(spheres.size(), c.count);
    double all = 0.0;
    for (const Gaussian& g : spheres) all += integral(g);
    EXPECT_NEAR(all / integral(equivalent_sphere(splat)), 1.0, 1e-12);
    const glm::dmat3 moments = second_moments(splat, spheres);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(moments[i][k], i == k ? c.extents[k] * c.extents[k] : 0.0, 1e-12);
      }
    }
  }
}

TEST(Splat, NearlyRoundOnesBecomeTheBallOfTheirVolume) {
  Splat splat;
  splat.deviations = {1.0, 1.1, 0.9};
  splat.depth = 2.0;
  const std::vector<Gaussian> spheres = sphere_approximation(splat);
  ASSERT_EQ(spheres.size(), 1u);
  EXPECT_EQ(spheres[0], equivalent_sphere(splat));
  EXPECT_NEAR(spheres[0].radius, std::sqrt(2.0) * std::cbrt(0.99), 1e-15);
  EXPECT_NEAR(spheres[0].density * std::sqrt(std::numbers::pi) * spheres[0].radius, 2.0, 1e-15);
}

}  // namespace
}  // namespace brume
