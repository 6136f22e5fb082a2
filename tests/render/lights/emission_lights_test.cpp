#include "render/lights/emission_lights.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/math/infinity.h"
#include "core/math/sphere_rule.h"
#include "render/slices/slice_kernels.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// A box around all, as large as the scene is to be.
const RayCaster& room() {
  static const RayCaster walls(
      std::array{placed(Primitive::Shape::box, glm::dvec3(4.0), glm::dvec3(0.0))});
  return walls;
}

Gaussian hot(const glm::dvec3& center, double radius, double density = 0.1) {
  return {center, radius, density, {std::nullopt, {8.0, 4.0, 2.0}}};
}

// Without absorption [W/sr].
double unattenuated(const Gaussian& g) {
  return std::pow(std::numbers::pi, 1.5) * std::pow(g.radius, 3.0) * g.density *
         g.optics.emission.x;
}

struct Made {
  MediumIndex index;
  EmissionLights lights;

  explicit Made(const std::vector<Gaussian>& gaussians, const RayCaster& surfaces = room())
      : index(
            [&] {
              Medium medium;
              for (const Gaussian& g : gaussians) medium.append(g);
              return medium;
            }(),
            1e-6) {
    lights.update(index, 1.0, &surfaces, {});
  }
};

// The share of what a light's Gaussians emit that gets far away, in the mean over directions.
double escaping_share(const EmissionLights::Light& light) {
  constexpr double far = 100.0;
  double share = 0.0;
  for (const SphereNode& node : sphere_rule(15)) {
    const std::array end{light.source.position + far * node.direction};
    PathBatch path;
    path.assign(light.source.position, end, std::array{-1});
    std::vector<float> depth(path.padded_size());
    lookup_depths(*light.table, path, depth.data());
    share += node.weight / (4.0 * std::numbers::pi) * std::exp(-static_cast<double>(depth[0]));
  }
  return share;
}

TEST(EmissionLights, NeighboursAreOneLight) {
  const Gaussian a = hot({0.0, 0.0, 0.0}, 0.02);
  const Gaussian b = hot({0.03, 0.0, 0.0}, 0.02, 0.3);
  const Made made{{a, b, {{0.5, 0.0, 0.0}, 0.5, 0.1}}};
  ASSERT_EQ(made.lights.lights().size(), 1u);
  const PointSource& source = made.lights.lights()[0].source;
  EXPECT_NEAR(source.position.x, 0.75 * 0.03, 1e-12);
  const double expected = unattenuated(a) + unattenuated(b);
  EXPECT_NEAR(source.intensity.x, expected, 0.01 * expected);
  EXPECT_NEAR(source.intensity.z, 0.25 * source.intensity.x, 1e-12);
  for (const RelativeOptics& optics : made.lights.held([](const auto&) { return true; })) {
    EXPECT_EQ(optics.emission, glm::dvec3(0.0));
  }
}

TEST(EmissionLights, WhatIsFarApartIsSeveral) {
  const Made made{
      {hot({-1.0, 0.0, 0.0}, 0.02), hot({1.0, 0.0, 0.0}, 0.02), hot({0.0, 1.0, 0.0}, 0.02)}};
  EXPECT_EQ(made.lights.lights().size(), 3u);
}

TEST(EmissionLights, LargeOnesAreLightsOfTheirOwn) {
  const Made made{{hot({0.0, 0.0, 0.0}, 0.5), hot({1.0, 0.0, 0.0}, 0.02)}};
  EXPECT_EQ(made.lights.lights().size(), 2u);
  const auto is_small = [](const EmissionLights::Light& light) { return light.width < 0.1; };
  const std::vector<RelativeOptics> held = made.lights.held(is_small);
  EXPECT_NE(held[0].emission, glm::dvec3(0.0));
  EXPECT_EQ(held[1].emission, glm::dvec3(0.0));
}

// A Gaussian of optical depth T through its center lets out Ein(T) / T of its light. What it emits
// is sampled at 64 points: 2% of the share where most is absorbed.
TEST(EmissionLights, LeavesOutWhatIsAbsorbedInIt) {
  for (const auto& [depth, share] : {std::pair(0.5, 0.888), std::pair(7.0, 0.3609)}) {
    SCOPED_TRACE(depth);
    const double radius = 0.05;
    const Gaussian g = hot({}, radius, depth / (radius * std::sqrt(std::numbers::pi)));
    const Made made{{g}};
    ASSERT_EQ(made.lights.lights().size(), 1u);
    EXPECT_NEAR(made.lights.lights()[0].source.intensity.x, unattenuated(g),
                1e-6 * unattenuated(g));
    EXPECT_NEAR(escaping_share(made.lights.lights()[0]), share, 0.02);
  }
}

// Many thick ones within each other, of which those at the rim send the most. From the centers of
// clusters half of it was lost.
TEST(EmissionLights, OfManyTheRimIsSeen) {
  Random random(3);
  std::vector<Gaussian> blob;
  for (int i = 0; i < 40; ++i) blob.push_back(hot(random.point(0.3), 0.1, 40.0));
  const Made made{blob};
  double escaping = 0.0;
  double all = 0.0;
  for (const EmissionLights::Light& light : made.lights.lights()) {
    escaping += light.source.intensity.x * escaping_share(light);
    all += light.source.intensity.x;
  }
  double expected = 0.0;
  constexpr int samples = 20000;
  for (int k = 0; k < samples; ++k) {
    glm::dvec3 offset(0.0);
    for (int i = 0; i < 12; ++i) offset += random.point(0.5);  // nearly normal
    glm::dvec3 w = random.point(1.0);
    while (glm::length(w) > 1.0) w = random.point(1.0);
    const glm::dvec3 x =
        blob[static_cast<std::size_t>(k) % 40].center + offset * 0.1 / std::numbers::sqrt2;
    expected += std::exp(-made.index.depth({x, glm::normalize(w), infinity})) / samples;
  }
  // So little is found by 64 points to a tenth.
  EXPECT_NEAR(escaping / all, expected, 0.1 * expected);
}

// Gaussians light nothing where they are below a floor or in a solid; the light is in the open.
TEST(EmissionLights, ShineWhereTheyAreInTheOpen) {
  const Surface floor = placed(Primitive::Shape::plane, {40.0, 1.0, 40.0}, glm::dvec3(0.0));
  const Surface log = placed(Primitive::Shape::box, {0.3, 0.3, 0.3}, {0.0, 0.15, 0.0});
  const Gaussian half_below = hot({3.0, 0.0, 3.0}, 0.1);
  const Gaussian on_top = hot({0.0, 0.35, 0.0}, 0.1);
  const Gaussian within = hot({0.0, 0.25, 0.0}, 0.1);
  const RayCaster surfaces(std::array{floor, log});
  for (const auto& [g, low, high] : {std::tuple(half_below, 0.4, 0.6), std::tuple(on_top, 0.7, 0.9),
                                     std::tuple(within, 0.1, 0.35)}) {
    SCOPED_TRACE(g.center.y);
    const Made made{{g}, surfaces};
    ASSERT_EQ(made.lights.lights().size(), 1u);
    const PointSource& source = made.lights.lights()[0].source;
    EXPECT_GT(source.intensity.x, low * unattenuated(g));
    EXPECT_LT(source.intensity.x, high * unattenuated(g));
    EXPECT_FALSE(surfaces.occluded(source.position, {source.position.x, 5.0, source.position.z}));
  }
}

// The middle of two in lanterns is outside of both.
TEST(EmissionLights, ShineInLanternsWhoseMiddleIsOutside) {
  const std::array lanterns{placed(Primitive::Shape::box, glm::dvec3(0.1), {-0.06, 0.0, 0.0}),
                            placed(Primitive::Shape::box, glm::dvec3(0.1), {0.06, 0.0, 0.0}),
                            placed(Primitive::Shape::plane, {40.0, 1.0, 40.0}, {0.0, -1.0, 0.0})};
  const Made made{{hot({-0.06, 0.0, 0.0}, 0.01), hot({0.06, 0.0, 0.0}, 0.01)}, RayCaster(lanterns)};
  ASSERT_EQ(made.lights.lights().size(), 1u);
  const EmissionLights::Light& light = made.lights.lights()[0];
  EXPECT_NEAR(light.source.intensity.x, 2.0 * unattenuated(hot({}, 0.01)), 1e-6);
  EXPECT_NEAR(std::abs(light.source.position.x), 0.06, 0.04);
  EXPECT_GT(escaping_share(light), 0.9);
}

TEST(EmissionLights, KeepsItsRevisionWhileNothingChanges) {
  Made made{{hot({}, 0.02)}};
  const Revision before = made.lights.revision();
  made.lights.update(made.index, 1.0, &room(), {});
  EXPECT_EQ(made.lights.revision(), before);
  made.lights.update(made.index, 0.5, &room(), {});
  EXPECT_NE(made.lights.revision(), before);
  const Revision in_the_room = made.lights.revision();
  made.lights.update(made.index, 0.5, nullptr, {});
  EXPECT_NE(made.lights.revision(), in_the_room);
  EXPECT_EQ(made.lights.lights().size(), 1u);
}

}  // namespace
}  // namespace brume
