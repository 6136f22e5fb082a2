#include "core/scene/lights/photometric_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/scene/lights/light_falloff.h"
#include "core/scene/lights/photometry.h"
#include "tests/random.h"

namespace brume {
namespace {

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
