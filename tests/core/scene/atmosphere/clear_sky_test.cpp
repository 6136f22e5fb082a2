#include "core/scene/atmosphere/clear_sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/math/sphere_rule.h"
#include "core/scene/atmosphere/slant_columns.h"

namespace brume {
namespace {

using std::numbers::pi;

// Illuminance or luminance, at 683 lumens per watt.
double photometric(const glm::dvec3& rgb) {
  return 683.0 * glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
}

// Grass and earth.
const glm::dvec3 ground(0.2);

// Of the upper half, on a horizontal surface.
glm::dvec3 sky_irradiance(const ClearSky& sky) {
  glm::dvec3 sum(0.0);
  for (const SphereNode& node : hemisphere_rule(512)) {
    const glm::dvec3 direction(node.direction.x, node.direction.z, node.direction.y);
    sum += node.weight * direction.y * sky.radiance(direction);
  }
  return sum;
}

double global_illuminance(double elevation, double turbidity) {
  const ClearSky sky(elevation, turbidity, ground);
  const double rise = std::max(std::sin(glm::radians(elevation)), 0.0);
  return photometric(sky_irradiance(sky) + rise * sky.sun_irradiance());
}

glm::dvec3 direction_of(double elevation, double azimuth) {
  const double e = glm::radians(elevation);
  const double a = glm::radians(azimuth);
  return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

// The turbidity of an aerosol optical depth at 500 nm.
double turbidity_of(double aerosol_depth) {
  constexpr double molecules_at_550 = 0.0972;
  return 1.0 + aerosol_depth * std::pow(550.0 / 500.0, -1.3) / molecules_at_550;
}

// Kasten and Young (1989), "Revised optical air mass tables": 1.994 at 30 degrees, 5.59 at 10,
// 10.3 at 5, 38 at the horizon with refraction, which bends grazing rays through less air: 5% at 5
// degrees.
TEST(Atmosphere, AirMassesAreThoseOfTables) {
  EXPECT_NEAR(slant_columns(0.0, 1.0).molecules, 1.0, 1e-3);
  EXPECT_NEAR(slant_columns(0.0, std::sin(glm::radians(30.0))).molecules, 1.994, 0.01);
  EXPECT_NEAR(slant_columns(0.0, std::sin(glm::radians(10.0))).molecules, 5.59, 0.08);
  EXPECT_NEAR(slant_columns(0.0, std::sin(glm::radians(5.0))).molecules, 10.3, 0.5);
  EXPECT_NEAR(slant_columns(0.0, 0.0).molecules, 36.0, 3.0);
}

TEST(Atmosphere, TableHoldsIntegratedColumns) {
  for (const double altitude : {0.0, 0.3, 3.0, 17.0, 33.0, 60.0}) {
    for (const double share : {0.0, 0.001, 0.01, 0.1, 0.5, 1.0}) {
      const double lowest = cos_horizon(altitude);
      const double cosine = lowest + share * (1.0 - lowest);
      const AirAmounts table = slant_columns(altitude, cosine);
      const AirAmounts integral = integrated_slant_columns(altitude, cosine);
      EXPECT_NEAR(table.molecules, integral.molecules, 0.003 * integral.molecules + 1e-9);
      EXPECT_NEAR(table.aerosol, integral.aerosol, 0.003 * integral.aerosol + 1e-9);
      EXPECT_NEAR(table.ozone, integral.ozone, 0.01 * integral.ozone + 1e-5)
          << altitude << ' ' << share;
    }
  }
}

// Light passes as much either way: from one end of a ray and from the other.
TEST(Atmosphere, TransmittanceIsReciprocal) {
  const Air air(3.0);
  const SkyRay up{0.0, 1.0, {0.3, 0.2}};
  const SkyRay end = up.moved(40.0);
  const SkyRay down{end.altitude, end.sun_zenith, {-end.direction.up, -end.direction.sunward}};
  ASSERT_TRUE(down.hits_ground());
  EXPECT_NEAR(down.length(), 40.0, 1e-6);
  const PathLight there = light_along(air, up, 2000, false, nullptr);
  const PathLight rest = light_along(air, end, 2000, false, nullptr);
  const PathLight back = light_along(air, down, 2000, false, nullptr);
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    EXPECT_NEAR(there.transmittance[k], rest.transmittance[k] * back.transmittance[k], 1e-3);
  }
}

TEST(Atmosphere, PhaseFunctionsAreNormalised) {
  double molecules = 0.0;
  double aerosol = 0.0;
  double mean_cosine = 0.0;
  const QuadratureRule rule = gauss_legendre(64);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double x = rule.nodes[i];
    molecules += 2.0 * pi * rule.weights[i] * molecule_phase(x);
    aerosol += 2.0 * pi * rule.weights[i] * aerosol_phase(x);
    mean_cosine += 2.0 * pi * rule.weights[i] * aerosol_phase(x) * x;
  }
  EXPECT_NEAR(molecules, 1.0, 1e-12);
  EXPECT_NEAR(aerosol, 1.0, 1e-9);
  EXPECT_NEAR(mean_cosine, 0.703, 5e-4);  // OPAC's continental average
}

// ASTM G-173: direct normal over extraterrestrial irradiance through an air mass of 1.5, an aerosol
// optical depth of 0.084 at 500 nm, 344 Dobson units of ozone (here 300). The direct light there
// has the glow around the sun in it, 1 to 2%; other gases absorb up to 1%.
TEST(Atmosphere, DirectSpectrumIsThatOfTheStandard) {
  struct Entry {
    std::size_t k;
    double wavelength, above, below;
  };
  const Air air(turbidity_of(0.084));
  for (const Entry& e : {Entry{1, 410.0, 1.5370, 0.80910}, Entry{2, 440.0, 1.8300, 1.0993},
                         Entry{3, 470.0, 1.9390, 1.2749}, Entry{4, 500.0, 1.9160, 1.3391},
                         Entry{5, 530.0, 1.8920, 1.3598}, Entry{6, 560.0, 1.7860, 1.3118},
                         Entry{8, 620.0, 1.7110, 1.3299}, Entry{10, 680.0, 1.4940, 1.2650}}) {
    ASSERT_EQ(wavelength_of(e.k), e.wavelength);
    const Spectrum light = sun_irradiance(air, 0.0, std::acos(1.0 / 1.5));
    EXPECT_NEAR(light[e.k], e.above > 0 ? e.below / e.above : 0.0, 0.025) << e.wavelength;
  }
}

// The same standard's global irradiance, of sun, sky and ground (light sandy soil, some 0.25 in the
// middle of the spectrum), on a plane that is tilted by 37 degrees to the sun. Its model (SMARTS)
// has two streams and another aerosol: its sky adds a quarter less, which is 7% of the whole.
TEST(Atmosphere, GlobalSpectrumIsThatOfTheStandard) {
  const Air air(turbidity_of(0.084));
  const double zenith = std::acos(1.0 / 1.5);
  const double tilt = glm::radians(37.0);
  const Spectrum reflectance = reflectance_spectrum({0.3, 0.25, 0.15});
  const ScatteredLight light(air, reflectance, zenith);
  const Spectrum soil = light.ground_radiance(air, reflectance, zenith);
  Spectrum sum{};
  for (const SphereNode& node : hemisphere_rule(512)) {
    // z is the normal, x is up on the plane.
    const double up = std::cos(tilt) * node.direction.z + std::sin(tilt) * node.direction.x;
    const double sunward = std::sin(tilt) * node.direction.z - std::cos(tilt) * node.direction.x;
    const SkyRay ray{0.0, zenith, {up, sunward}};
    const double weight = node.weight * node.direction.z;
    if (up <= 0.0) {
      for (std::size_t k = 0; k < spectrum_size; ++k) sum[k] += weight * soil[k];
      continue;
    }
    const PathLight path = light_along(air, ray, 48, true, &light.radiance);
    for (std::size_t k = 0; k < spectrum_size; ++k) {
      sum[k] += weight * (path.once(k, ray.cos_sun()) + path.again[k]);
    }
  }
  // The sun is 11.2 degrees off the normal.
  const double facing = std::cos(zenith - tilt);
  const Spectrum direct = sun_irradiance(air, 0.0, zenith);
  const auto expect_global = [&](std::size_t k, double above, double global) {
    EXPECT_NEAR(facing * direct[k] + sum[k], global / above, 0.08 * global / above) << k;
  };
  expect_global(1, 1.5370, 1.0485);
  expect_global(2, 1.8300, 1.3499);
  expect_global(4, 1.9160, 1.5451);
  expect_global(6, 1.7860, 1.4740);
  expect_global(8, 1.7110, 1.4739);
  expect_global(10, 1.4940, 1.3969);
}

// Illuminating Engineering Society, "Recommended Practice for the Calculation of Daylight
// Availability" (1984), clear sky: direct normal 127.5 exp(-0.21 / sin h) klx, horizontal from the
// sky 0.8 + 15.5 sqrt(sin h) klx. Means of measurements: single skies may be half or twice as
// bright.
TEST(ClearSky, IlluminancesAreThoseOfDaylightPractice) {
  for (const double elevation : {15.0, 30.0, 45.0, 60.0}) {
    const double sine = std::sin(glm::radians(elevation));
    const ClearSky sky(elevation, 2.2, ground);
    const double direct = 127.5e3 * std::exp(-0.21 / sine);
    EXPECT_NEAR(photometric(sky.sun_irradiance()), direct, 0.1 * direct) << elevation;
    const double diffuse = 1e3 * (0.8 + 15.5 * std::sqrt(sine));
    EXPECT_NEAR(photometric(sky_irradiance(sky)), diffuse, 0.35 * diffuse) << elevation;
  }
}

// Zenith luminance of clear skies, Krochmann 1970 (DIN 5034): 100 + 63 h + h (h - 30)
// exp(0.0346 (h - 68)) cd/m^2 at an elevation of h degrees.
TEST(ClearSky, ZenithIsAsBrightAsMeasured) {
  for (const double h : {10.0, 20.0, 30.0, 45.0, 60.0}) {
    const double measured = 100.0 + 63.0 * h + h * (h - 30.0) * std::exp(0.0346 * (h - 68.0));
    const ClearSky sky(h, 2.5, ground);
    EXPECT_NEAR(photometric(sky.radiance({0, 1, 0})), measured, 0.4 * measured) << h;
  }
}

// CIE Standard General Sky (CIE S 011 / ISO 15469), type 12 (clear, low turbidity): luminance
// relative to the zenith. The model's skies need not be of that type: within a third away from sun
// and horizon.
TEST(ClearSky, LuminancesAreDistributedAsInTheStandardClearSky) {
  const double sun_zenith = glm::radians(50.0);
  const auto gradation = [](double zenith) {
    return 1.0 - 1.0 * std::exp(-0.32 / std::cos(zenith));
  };
  const auto indicatrix = [](double angle) {
    return 1.0 + 10.0 * (std::exp(-3.0 * angle) - std::exp(-3.0 * pi / 2.0)) +
           0.45 * std::cos(angle) * std::cos(angle);
  };
  const ClearSky sky(40.0, 2.4, ground);
  const double at_zenith = photometric(sky.radiance({0, 1, 0}));
  const glm::dvec3 sun = direction_of(40.0, 0.0);
  for (const double elevation : {20.0, 40.0, 60.0}) {
    for (const double azimuth : {60.0, 90.0, 120.0, 180.0}) {
      const glm::dvec3 w = direction_of(elevation, azimuth);
      const double angle = std::acos(glm::dot(w, sun));
      const double standard = gradation(glm::radians(90.0 - elevation)) * indicatrix(angle) /
                              (gradation(0.0) * indicatrix(sun_zenith));
      EXPECT_NEAR(photometric(sky.radiance(w)) / at_zenith, standard, 0.35 * standard)
          << elevation << ' ' << azimuth;
    }
  }
}

// The Glossary of Meteorology (American Meteorological Society), civil twilight: 585 to 410 lx at
// its begin, when the sun's upper edge has set (elevation -0.8 degrees), 3.5 to 2 lx at its end, -6
// degrees; refraction is left out here, which is half a degree, or a factor of 1.6 at -6 degrees.
TEST(ClearSky, TwilightIsAsDarkAsMeasured) {
  EXPECT_NEAR(global_illuminance(-0.8, 2.5), 500.0, 200.0);
  const double end = global_illuminance(-6.0, 2.5);
  EXPECT_GT(end, 1.5);
  EXPECT_LT(end, 7.0);
}

// Solar illuminance outside the atmosphere is 128 to 133 klx (the standards differ); noon under a
// high sun is 110 to 130 klx.
TEST(ClearSky, NoonIsAsBrightAsMeasured) {
  Spectrum all;
  all.fill(1.0);
  EXPECT_NEAR(photometric(rec709_of_sunlight(all)), 130.5e3, 3.5e3);
  EXPECT_NEAR(global_illuminance(90.0, 2.5), 120e3, 8e3);
}

TEST(ClearSky, SkyIsBlueAndLowSunsAreRed) {
  const ClearSky noon(60.0, 2.0, ground);
  const glm::dvec3 zenith = noon.radiance({0, 1, 0});
  EXPECT_GT(zenith.b, 1.3 * zenith.g);
  EXPECT_GT(zenith.g, zenith.r);
  double last = 0.0;
  for (const double elevation : {60.0, 20.0, 8.0, 3.0, 1.0}) {
    const glm::dvec3 sun = ClearSky(elevation, 2.0, ground).sun_irradiance();
    EXPECT_GT(sun.r / sun.g, last) << elevation;
    last = sun.r / sun.g;
  }
  EXPECT_GT(last, 3.0);
}

// Light scattered once, by plain sums over the ray and over the way to the sun.
TEST(ClearSky, SingleScatteringIsTheIntegral) {
  const Air air(2.5);
  const double sun_zenith = glm::radians(70.0);
  const SkyRay ray{0.0, sun_zenith, {std::sin(glm::radians(25.0)), 0.4}};
  const PathLight light = light_along(air, ray, 48, true, nullptr);
  Spectrum molecules{};
  Spectrum depth{};
  constexpr int steps = 4000;
  const double span = ray.length() / steps;
  for (int i = 0; i < steps; ++i) {
    const SkyRay place = ray.moved((i + 0.5) * span);
    const AirAmounts density = air_density(place.altitude);
    const AirAmounts columns = integrated_slant_columns(place.altitude, std::cos(place.sun_zenith));
    for (std::size_t k = 0; k < spectrum_size; ++k) {
      const double here = span * air.depth(density, k);
      molecules[k] += span * density.molecules * air.molecules[k] *
                      std::exp(-depth[k] - 0.5 * here - air.depth(columns, k));
      depth[k] += here;
    }
  }
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    EXPECT_NEAR(light.once_by_molecules[k], molecules[k], 0.005 * molecules[k]) << k;
    EXPECT_NEAR(light.transmittance[k], std::exp(-depth[k]), 0.005) << k;
  }
}

// Thin air scatters once: what the sky is, is its optical depth times the phase function.
TEST(ClearSky, ThinAirScattersOnce) {
  Air air(1.0);
  for (Spectrum* spectrum : {&air.molecules, &air.ozone}) {
    for (double& depth : *spectrum) depth *= 1e-4;
  }
  const double sun_zenith = glm::radians(40.0);
  const ScatteredLight scattered(air, Spectrum{}, sun_zenith);
  const SkyRay zenith{0.0, sun_zenith, {1.0, 0.0}};
  const PathLight light = light_along(air, zenith, 48, true, &scattered.radiance);
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    EXPECT_NEAR(light.once_by_molecules[k], air.molecules[k], 3e-3 * air.molecules[k]);
    EXPECT_LT(light.again[k], 1e-3 * light.once_by_molecules[k]);
  }
}

// Without absorption by air or ground, all light that enters leaves: over a white ground as much
// goes down as up.
TEST(ClearSky, WhiteGroundUnderClearAirLosesNoLight) {
  Air air(1.0);
  air.ozone.fill(0.0);
  Spectrum white;
  white.fill(1.0);
  const double sun_zenith = glm::radians(40.0);
  const ScatteredLight scattered(air, white, sun_zenith);
  const Spectrum direct = sun_irradiance(air, 0.0, sun_zenith);
  const Spectrum reflected = scattered.ground_radiance(air, white, sun_zenith);
  // At the top of the atmosphere: the flux that leaves is the sun's that enters.
  Spectrum leaving{};
  for (const SphereNode& node : hemisphere_rule(512)) {
    const SkyRay ray{atmosphere_height, sun_zenith, {-node.direction.z, node.direction.x}};
    PathLight path = light_along(air, ray, 96, true, &scattered.radiance);
    for (std::size_t k = 0; k < spectrum_size; ++k) {
      double radiance = path.once(k, ray.cos_sun()) + path.again[k];
      if (ray.hits_ground()) radiance += path.transmittance[k] * reflected[k];
      leaving[k] += node.weight * node.direction.z * radiance;
    }
  }
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    EXPECT_LT(direct[k], 1.0);
    EXPECT_NEAR(leaving[k], std::cos(sun_zenith), 0.04 * std::cos(sun_zenith)) << k;
  }
}

TEST(ClearSky, IsEvenAboutTheSun) {
  const ClearSky sky(25.0, 3.0, ground);
  for (const double azimuth : {10.0, 70.0, 150.0}) {
    EXPECT_EQ(sky.radiance(direction_of(20.0, azimuth)),
              sky.radiance(direction_of(20.0, -azimuth)));
  }
}

TEST(ClearSky, BrightGroundsMakeBrighterSkies) {
  const glm::dvec3 dark = ClearSky(40.0, 3.0, glm::dvec3(0.0)).radiance({0, 1, 0});
  const glm::dvec3 bright = ClearSky(40.0, 3.0, glm::dvec3(0.8)).radiance({0, 1, 0});
  const glm::dvec3 red = ClearSky(40.0, 3.0, {0.8, 0.0, 0.0}).radiance({0, 1, 0});
  for (int c = 0; c < 3; ++c) EXPECT_GT(bright[c], 1.05 * dark[c]);
  EXPECT_GT(red.r / dark.r, red.b / dark.b);
  EXPECT_EQ(ClearSky(40.0, 3.0, glm::dvec3(0.0)).radiance({0, -1, 0}), glm::dvec3(0.0));
}

// From night to noon: no jumps, more light, nothing negative.
TEST(ClearSky, DaysBreakSmoothly) {
  double last = 0.0;
  for (double elevation = -20.0; elevation <= 10.0; elevation += 2.0) {
    const double now = global_illuminance(elevation, 3.0);
    EXPECT_GE(now, 0.999 * last) << elevation;
    if (last > 0.0) {
      EXPECT_LT(now, 12.0 * last) << elevation;
    }
    last = now;
  }
  const double below = global_illuminance(-0.01, 3.0);
  EXPECT_NEAR(global_illuminance(0.01, 3.0), below, 0.02 * below);
}

TEST(ClearSky, NightsAreDimAndEven) {
  const ClearSky night(-40.0, 3.0, ground);
  EXPECT_EQ(night.sun_irradiance(), glm::dvec3(0.0));
  const double luminance = photometric(night.radiance({0, 1, 0}));
  EXPECT_GT(luminance, 1e-4);
  EXPECT_LT(luminance, 3e-4);
  EXPECT_EQ(night.radiance({0, 1, 0}), night.radiance(direction_of(5.0, 77.0)));
}

TEST(ClearSky, EveryElevationAndTurbidityIsFinite) {
  for (const double turbidity : {1.0, 10.0}) {
    for (const double elevation : {-90.0, -0.265, 0.0, 90.0}) {
      const ClearSky sky(elevation, turbidity, glm::dvec3(1.0));
      for (const glm::dvec3& w : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0),
                                  glm::dvec3(0, -1, 0), direction_of(elevation, 0.0)}) {
        const glm::dvec3 radiance = sky.radiance(w);
        for (int c = 0; c < 3; ++c) {
          EXPECT_TRUE(std::isfinite(radiance[c])) << turbidity << ' ' << elevation;
          EXPECT_GE(radiance[c], 0.0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace brume
