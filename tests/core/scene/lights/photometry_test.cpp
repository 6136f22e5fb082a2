#include "core/scene/lights/photometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/scene/lights/light_falloff.h"

namespace brume {
namespace {

// The chromaticity of linear Rec. 709.
glm::dvec2 chromaticity(const glm::dvec3& c) {
  const double x = 0.4124564 * c.r + 0.3575761 * c.g + 0.1804375 * c.b;
  const double y = 0.2126729 * c.r + 0.7151522 * c.g + 0.0721750 * c.b;
  const double z = 0.0193339 * c.r + 0.1191920 * c.g + 0.9503041 * c.b;
  return {x / (x + y + z), y / (x + y + z)};
}

// CIE's tables of the Planckian locus.
TEST(Photometry, BlackBodiesHaveTheirChromaticities) {
  struct Place {
    double temperature, x, y;
  };
  for (const Place& p : {Place{2856.0, 0.4476, 0.4074}, Place{4000.0, 0.3805, 0.3768},
                         Place{6500.0, 0.3135, 0.3237}, Place{10000.0, 0.2807, 0.2884}}) {
    const glm::dvec2 c = chromaticity(black_body_color(p.temperature));
    EXPECT_NEAR(c.x, p.x, 0.003) << p.temperature;
    EXPECT_NEAR(c.y, p.y, 0.003) << p.temperature;
  }
}

TEST(Photometry, BlackBodiesAreRedWhenColdAndBlueWhenHot) {
  for (const double t : {0.0, 800.0, 1850.0, 6500.0, 40000.0, 1e9}) {
    const glm::dvec3 c = black_body_color(t);
    EXPECT_EQ(std::max({c.r, c.g, c.b}), 1.0) << t;
    EXPECT_GE(std::min({c.r, c.g, c.b}), 0.0) << t;
    EXPECT_EQ(c.r == 1.0, t < 6600.0) << t;
  }
}

// The candela was defined by 60 cd/cm^2 at the freezing point of platinum, 2041.4 K (the fitted
// observer's efficiency errs by up to 1% there); and 800 K is where bodies begin to glow.
TEST(Photometry, BlackBodiesHaveTheirLuminance) {
  EXPECT_NEAR(lumens_per_watt * luminance(black_body_radiance(2041.4)), 6e5, 0.02 * 6e5);
  EXPECT_EQ(black_body_radiance(799.0), glm::dvec3(0.0));
  EXPECT_EQ(black_body_radiance(std::nan("")), glm::dvec3(0.0));
  EXPECT_GT(black_body_radiance(801.0).r, 0.0);
  EXPECT_EQ(black_body_radiance(1e9), black_body_radiance(40000.0));
  for (const double t : {801.0, 1234.5, 1850.0, 6500.0, 39999.0}) {
    const glm::dvec3 radiance = black_body_radiance(t);
    const glm::dvec3 color = radiance / std::max({radiance.r, radiance.g, radiance.b});
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(color[k], black_body_color(t)[k], 1e-3) << t;
  }
}

TEST(Photometry, FindsTheTemperatureOfAColour) {
  for (const double t : {850.0, 1850.0, 2856.0, 5500.0, 6504.0, 12000.0, 39000.0}) {
    EXPECT_NEAR(nearest_temperature(black_body_color(t)), t, 1e-3 * t);
  }
}

TEST(Photometry, ALightOfAllDirectionsIsFourPiCandela) {
  Light light;
  light.intensity = glm::dvec3(1.0 / lumens_per_watt);
  EXPECT_NEAR(photometric_strength(light), 1.0, 1e-12);
  EXPECT_NEAR(*luminous_flux(light), 4.0 * std::numbers::pi, 1e-9);
  light.intensity = glm::dvec3(0.0, 1.0, 0.0);
  EXPECT_NEAR(photometric_strength(light), 0.7152 * lumens_per_watt, 1e-9);
  light.kind = light::Directional();
  EXPECT_FALSE(luminous_flux(light));
}

TEST(Photometry, TheFluxOfASpotIsTheIntegralOfItsFalloff) {
  for (const auto& [inner, outer] :
       {std::pair{0.0, 45.0}, {10.0, 12.0}, {60.0, 130.0}, {179.0, 180.0}, {0.0, 0.5}}) {
    Light light;
    light.intensity = glm::dvec3(1.0);
    light.kind = light::Spot{{0.0, 0.0, 1.0}, inner, outer};
    const LightFalloff falloff(*light.as<light::Spot>());
    constexpr int steps = 2'000'000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double cosine = 2.0 * (i + 0.5) / steps - 1.0;
      sum += falloff.at({std::sqrt(1.0 - cosine * cosine), 0.0, cosine});
    }
    const double expected = lumens_per_watt * 2.0 * std::numbers::pi * sum * 2.0 / steps;
    EXPECT_NEAR(*luminous_flux(light), expected, 1e-4 * expected + 1e-3) << inner << " " << outer;
  }
}

// Those of cones too narrow for sums over cosines: the solid angle of the inner one where both are
// equal, a third of the difference with a soft edge down to the axis.
TEST(Photometry, TheFluxOfANarrowSpotIsThatOfItsCone) {
  for (const double outer : {0.05, 0.1, 1.0}) {
    Light light;
    light.intensity = glm::dvec3(1.0);
    const double sine = std::sin(glm::radians(0.5 * outer));
    const double solid_angle = 4.0 * std::numbers::pi * sine * sine;
    light.kind = light::Spot{{0.0, 0.0, 1.0}, outer, outer};
    EXPECT_NEAR(*luminous_flux(light), lumens_per_watt * solid_angle,
                0.01 * lumens_per_watt * solid_angle);
    light.as<light::Spot>()->inner_angle = 0.0;
    EXPECT_NEAR(*luminous_flux(light), lumens_per_watt * solid_angle / 3.0,
                1e-6 * lumens_per_watt * solid_angle);
  }
}

}  // namespace
}  // namespace brume
