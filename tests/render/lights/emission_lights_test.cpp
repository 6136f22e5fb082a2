#include "render/lights/emission_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brume {
namespace {

// Bounds of what is around.
const Box room_box{glm::dvec3(-2.0), glm::dvec3(2.0)};

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

  explicit Made(std::initializer_list<Gaussian> gaussians)
      : index(
            [&] {
              Medium medium;
              for (const Gaussian& g : gaussians) medium.append(g);
              return medium;
            }(),
            1e-6) {
    lights.update(index, 1.0, room_box, {});
  }
};

TEST(EmissionLights, NeighboursAreOneLight) {
  const Gaussian a = hot({0.0, 0.0, 0.0}, 0.02);
  const Gaussian b = hot({0.03, 0.0, 0.0}, 0.02, 0.3);
  const Made made{a, b, {{0.5, 0.0, 0.0}, 0.5, 0.1}};
  ASSERT_EQ(made.lights.lights().size(), 1u);
  const PointSource& source = made.lights.lights()[0].source;
  EXPECT_NEAR(source.position.x, 0.75 * 0.03, 1e-12);
  // Hardly any of it is absorbed.
  const double expected = unattenuated(a) + unattenuated(b);
  EXPECT_NEAR(source.intensity.x, expected, 0.01 * expected);
  EXPECT_NEAR(source.intensity.z, 0.25 * source.intensity.x, 1e-12);
  for (const RelativeOptics& optics : made.lights.held([](const auto&) { return true; })) {
    EXPECT_EQ(optics.emission, glm::dvec3(0.0));
  }
}

TEST(EmissionLights, WhatIsFarApartIsSeveral) {
  const Made made{hot({-1.0, 0.0, 0.0}, 0.02), hot({1.0, 0.0, 0.0}, 0.02),
                  hot({0.0, 1.0, 0.0}, 0.02)};
  EXPECT_EQ(made.lights.lights().size(), 3u);
}

TEST(EmissionLights, LargeOnesAreLightsOfTheirOwn) {
  const Made made{hot({0.0, 0.0, 0.0}, 0.5), hot({1.0, 0.0, 0.0}, 0.02)};
  EXPECT_EQ(made.lights.lights().size(), 2u);
  const auto is_small = [](const EmissionLights::Light& light) { return light.width < 0.1; };
  const std::vector<RelativeOptics> held = made.lights.held(is_small);
  EXPECT_NE(held[0].emission, glm::dvec3(0.0));
  EXPECT_EQ(held[1].emission, glm::dvec3(0.0));
}

// A Gaussian of optical depth T through its center lets out Ein(T) / T of its light: 0.888 at 0.5.
TEST(EmissionLights, LeavesOutWhatIsAbsorbedInIt) {
  const double radius = 0.05;
  const Gaussian g = hot({}, radius, 0.5 / (radius * std::sqrt(std::numbers::pi)));
  const Made made{g};
  ASSERT_EQ(made.lights.lights().size(), 1u);
  EXPECT_NEAR(made.lights.lights()[0].source.intensity.x, 0.888 * unattenuated(g),
              1e-3 * unattenuated(g));
  EXPECT_TRUE(made.lights.lights()[0].table->empty());
}

TEST(EmissionLights, KeepsItsRevisionWhileNothingChanges) {
  Made made{hot({}, 0.02)};
  const Revision before = made.lights.revision();
  made.lights.update(made.index, 1.0, room_box, {});
  EXPECT_EQ(made.lights.revision(), before);
  made.lights.update(made.index, 0.5, room_box, {});
  EXPECT_NE(made.lights.revision(), before);
}

}  // namespace
}  // namespace brume
