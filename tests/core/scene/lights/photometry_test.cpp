#include "core/scene/lights/photometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/scene/lights/light_falloff.h"
#include "core/scene/lights/photometric_profile.h"
#include "tests/random.h"

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

// Sampled at every degree.
template <class Intensity>
PhotometricProfile sampled(Intensity&& intensity, double last_polar = 180.0) {
  std::vector<double> polar;
  std::vector<double> azimuths;
  std::vector<double> values;
  for (double p = 0.0; p <= last_polar; p += 1.0) polar.push_back(p);
  for (double a = 0.0; a <= 360.0; a += 1.0) {
    azimuths.push_back(a);
    for (const double p : polar) values.push_back(intensity(glm::radians(p), glm::radians(a)));
  }
  return {polar, azimuths, values};
}

double cosine(double polar, double) {
  return std::max(std::cos(polar), 0.0);
}

// Two lobes to the sides, one of them stronger.
double lobes(double polar, double azimuth) {
  return 100.0 * std::exp(-8.0 * std::pow(polar - 0.9, 2)) * (1.2 + std::cos(azimuth)) *
         (1.0 + std::pow(std::sin(azimuth), 2));
}

glm::dvec3 direction(double polar, double azimuth) {
  return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
          std::cos(polar)};
}

TEST(PhotometricProfile, IsOneInAllDirectionsIfIsotropic) {
  const PhotometricProfile profile = PhotometricProfile::isotropic();
  Random random(3);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(profile.at(random.point(2.0)), 1.0);
  EXPECT_NEAR(profile.solid_angle(), 4.0 * std::numbers::pi, 1e-12);
  for (const float value : profile.map()->values) EXPECT_EQ(value, 1.0f);
}

// Linear interpolation over a degree errs by an eighth of its square.
TEST(PhotometricProfile, IsItsClosedForm) {
  constexpr double bound = 0.125 * 0.0174533 * 0.0174533;
  const PhotometricProfile by_cosine = sampled(cosine);
  const PhotometricProfile front_only = sampled(cosine, 90.0);
  EXPECT_NEAR(by_cosine.solid_angle(), std::numbers::pi, 4.0 * bound);
  EXPECT_NEAR(front_only.solid_angle(), std::numbers::pi, 4.0 * bound);
  const PhotometricProfile by_lobes = sampled(lobes);
  double greatest = 0.0;
  for (double p = 0.0; p <= 180.0; p += 1.0) {
    for (double a = 0.0; a <= 360.0; a += 1.0) {
      greatest = std::max(greatest, lobes(glm::radians(p), glm::radians(a)));
    }
  }
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 w = glm::normalize(random.point(1.0));
    const double polar = std::acos(w.z);
    EXPECT_NEAR(by_cosine.at(3.0 * w), cosine(polar, 0.0), bound);
    EXPECT_NEAR(front_only.at(w), cosine(polar, 0.0), bound);
    const double expected = lobes(polar, std::atan2(w.y, w.x)) / greatest;
    EXPECT_NEAR(by_lobes.at(w), expected, 30.0 * bound);  // it bends more
  }
}

TEST(PhotometricProfile, IntegratesAsItsValuesDo) {
  const PhotometricProfile profile = sampled(lobes, 120.0);
  double sum = 0.0;
  constexpr int parts = 720;
  const double step = std::numbers::pi / parts;
  for (int i = 0; i < parts; ++i) {
    for (int k = 0; k < parts; ++k) {
      const double polar = (i + 0.5) * step;
      sum += std::sin(polar) * profile.at(direction(polar, (k + 0.5) * 2.0 * step));
    }
  }
  EXPECT_NEAR(profile.solid_angle(), sum * 2.0 * step * step, 1e-4 * profile.solid_angle());
}

TEST(PhotometricProfile, OneAngleIsARing) {
  const PhotometricProfile ring({90.0}, {0.0, 360.0}, {5.0, 5.0});
  EXPECT_EQ(ring.at({1.0, 0.0, 0.0}), 1.0);
  EXPECT_EQ(ring.at({0.0, 0.0, 1.0}), 0.0);
  EXPECT_EQ(ring.solid_angle(), 0.0);
}

LightProfile lobed(double rotation) {
  return {"a.ies", std::make_shared<const PhotometricProfile>(sampled(lobes)), rotation};
}

// Hanging, azimuths count counterclockwise as seen from above, from +x on.
TEST(PhotometricProfile, HangsDown) {
  const light::Point hanging{lobed(0.0)};
  const LightFalloff falloff(hanging);
  const LightFalloff turned_falloff(light::Point{lobed(30.0)});
  const double turn = glm::radians(30.0);
  for (const double polar : {0.2, 0.9, 2.0}) {
    for (const double azimuth : {0.0, 0.7, 2.5, 5.0}) {
      const double value = hanging.profile.content->at(direction(polar, azimuth));
      const auto in_world = [&](double a) {
        return glm::dvec3(std::sin(polar) * std::cos(a), -std::cos(polar),
                          -std::sin(polar) * std::sin(a));
      };
      EXPECT_NEAR(falloff.at(in_world(azimuth)), value, 1e-9);
      EXPECT_NEAR(turned_falloff.at(in_world(azimuth + turn)), value, 1e-9);
    }
  }
}

// A spot turns it the shortest way, and cuts off what is outside its cone.
TEST(PhotometricProfile, TurnsWithASpot) {
  const light::Spot sideways{{0.0, 0.0, 2.0}, 179.0, 180.0, lobed(0.0)};
  const LightFalloff falloff(sideways);
  const PhotometricProfile& profile = *sideways.profile.content;
  const double value = profile.at(direction(0.6, 0.4));
  // About x: down to +z, so what pointed to -z points down.
  const glm::dvec3 w(std::sin(0.6) * std::cos(0.4), -std::sin(0.6) * std::sin(0.4), std::cos(0.6));
  EXPECT_NEAR(falloff.at(w), value, 1e-9);
  for (const glm::dvec3& up : {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(1e-9, 1.0, 0.0)}) {
    const LightFalloff inverted(light::Spot{up, 10.0, 20.0, lobed(0.0)});
    EXPECT_NEAR(inverted.at(glm::normalize(up)), profile.at({0.0, 0.0, 1.0}), 1e-9);
    EXPECT_EQ(inverted.at({1.0, 0.0, 0.0}), 0.0);
  }
}

TEST(PhotometricProfile, FluxIsThatOfTheClosedForm) {
  LightProfile profile;
  profile.content = std::make_shared<const PhotometricProfile>(sampled(cosine));
  Light light{.kind = light::Point{profile}};
  const double flux = lumens_per_watt * std::numbers::pi;
  EXPECT_NEAR(*luminous_flux(light), flux, 2e-4 * flux);
  light.kind = light::Spot{{1.0, 0.0, 0.0}, 59.9999, 60.0, profile};
  EXPECT_NEAR(*luminous_flux(light), 0.75 * flux, 2e-3 * flux);  // sin^2 of 60 degrees
  profile.content = std::make_shared<const PhotometricProfile>(PhotometricProfile::isotropic());
  light.kind = light::Spot{{1.0, 0.0, 0.0}, 20.0, 50.0, profile};
  const Light plain{.kind = light::Spot{{1.0, 0.0, 0.0}, 20.0, 50.0}};
  EXPECT_NEAR(*luminous_flux(light), *luminous_flux(plain), 1e-4 * *luminous_flux(plain));
}

}  // namespace

}  // namespace brume
