// The Monte Carlo reference of surfaces against quadrature, and the paper's surface model against
// the reference.

#include "render/reference/surface_reference.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/math/infinity.h"
#include "core/math/quadrature.h"
#include "core/math/sphere_rule.h"
#include "core/scene/lights/environment.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/materials/brdf.h"
#include "core/transport/closed_form_airlight.h"
#include "core/transport/point_spread.h"
#include "render/reference/airlight_integral.h"
#include "tests/core/math/sh_convolve.h"
#include "tests/core/transport/incident_light.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

using std::numbers::pi;

// A point of a surface at the origin that looks along +z, seen from above.
SurfacePoint upward(const Surface& surface) {
  SurfacePoint point;
  point.normal = {0, 0, 1};
  point.to_eye = glm::normalize(glm::dvec3(0.3, 0.2, 1));
  point.surface = &surface;
  return point;
}

// The integral over the upper half space of cos(theta) radiance(w), where the radiance is brightest
// around a direction.
template <class Radiance>
double irradiance(const glm::dvec3& brightest, const Radiance& radiance, std::size_t n) {
  const QuadratureRule rule = gauss_legendre(n);
  const glm::dquat frame = surface_frame(brightest, brightest);
  const int azimuths = 2 * static_cast<int>(n);
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double gamma = 0.5 * pi * (1.0 + rule.nodes[i]);
    for (int k = 0; k < azimuths; ++k) {
      const double phi = 2.0 * pi * k / azimuths;
      const glm::dvec3 w = frame * glm::dvec3(std::sin(gamma) * std::cos(phi),
                                              std::sin(gamma) * std::sin(phi), std::cos(gamma));
      if (!(w.z > 0.0)) continue;
      sum +=
          0.5 * pi * rule.weights[i] * (2.0 * pi / azimuths) * std::sin(gamma) * w.z * radiance(w);
    }
  }
  return sum;
}

void expect_within_error(const ReflectedLight& light, double attenuated, double scattered) {
  // Five standard errors: a chance of 1e-6.
  EXPECT_NEAR(light.attenuated.x, attenuated, 5.0 * light.error.x + 1e-9 * attenuated);
  EXPECT_NEAR(light.scattered.x, scattered, 5.0 * light.error.x);
  EXPECT_LT(light.error.x, 0.02 * scattered) << "too noisy to tell";
}

TEST(SurfaceReference, MatchesALightInAHomogeneousMedium) {
  const Surface surface;  // diffuse, 0.5
  Scene scene;
  scene.medium.set_homogeneous_density(0.4);
  const glm::dvec3 light(1.0, 0.5, 2.0);
  scene.lights.push_back({light, {3, 3, 3}, {}});
  const double D = glm::length(light);
  const double unscattered = 0.5 / pi * 3.0 * light.z / (D * D * D) * std::exp(-0.4 * D);
  const double scattered =
      0.5 / pi * 3.0 *
      irradiance(
          light / D,
          [&](const glm::dvec3& w) {
            return homogeneous_airlight(0.4, PointLightRay<double>(light, glm::dvec3(0), w, 0.0),
                                        infinity);
          },
          60);
  const ReflectedLight got =
      reflected_light(scene, RayCaster({}), upward(surface), {.samples = 200'000});
  expect_within_error(got, unscattered, scattered);
}

TEST(SurfaceReference, MatchesALightInAnAbsorbingMedium) {
  Surface surface;
  surface.material.type = Material::Type::phong;
  surface.material.specular = glm::dvec3(0.4);
  surface.material.exponent = 5.0;
  Scene scene = in_fog(cloud_scene(5, 1.5), 0.05);
  scene.optics.anisotropy = 0.5;
  const glm::dvec3 light(1.0, 0.5, 2.0);
  scene.lights = {{light, {3, 3, 3}, {}}};
  const SurfacePoint point = upward(surface);
  const auto f = [&](const glm::dvec3& w) {
    return brdf(surface.material, w, point.to_eye, point.normal).x;
  };
  const GaussianTerms<double> terms(scene.medium);
  const auto gaussians = terms.all();
  double depth = 0.05 * glm::length(light);
  for (const GaussianTerm<double>& g : gaussians) depth += optical_depth(g, glm::dvec3(0), light);
  const LightSource<double> source{light, 0.0, gaussians, 0.5, std::nullopt};
  const double scattered =
      3.0 * irradiance(
                glm::normalize(light),
                [&](const glm::dvec3& w) {
                  const ViewRayMedium<double> medium(gaussians, 0.05, glm::dvec3(0), w, infinity);
                  return f(w) * airlight_integral(medium, source, 1e-6);
                },
                40);
  const double D = glm::length(light);
  const double unscattered = 3.0 * f(light / D) * light.z / (D * D * D) * std::exp(-depth);
  const ReflectedLight got = reflected_light(scene, RayCaster({}), point, {.samples = 200'000});
  expect_within_error(got, unscattered, scattered);

  // Absorption alone, where nothing is scattered but the depth is divided by the albedo.
  scene.optics.albedo = {1.0, 0.5, 1.0};
  const ReflectedLight tinted = reflected_light(scene, RayCaster({}), point, {.samples = 200'000});
  EXPECT_NEAR(tinted.attenuated.y, unscattered * std::exp(-depth), 1e-9 * unscattered);
  EXPECT_EQ(tinted.scattered.x, got.scattered.x);
  EXPECT_LT(tinted.scattered.y, got.scattered.y);
}

TEST(SurfaceReference, MatchesAConstantEnvironment) {
  const Surface surface;
  Scene scene;
  const double b0 = 0.1;
  const double far = 10.0;
  scene.medium.set_homogeneous_density(b0);
  scene.environment = even_sky(2.0f);
  // From a point at t the medium ends where the ball does; averaged over all directions.
  const auto from = [&](double t) {
    const auto f = [&](double cosine) {
      const double out = std::sqrt(far * far - t * t * (1.0 - cosine * cosine)) - t * cosine;
      return 0.5 * std::exp(-b0 * out);
    };
    const std::array<double, 2> all = {-1.0, 1.0};
    return b0 * std::exp(-b0 * t) * integrate<double>(f, all, 1e-9).value;
  };
  const std::array<double, 2> all = {0.0, far};
  const double scattered = 0.5 * 2.0 * integrate<double>(from, all, 1e-8).value;
  const ReflectedLight got =
      reflected_light(scene, RayCaster({}), upward(surface), {.samples = 100'000, .far = far});
  expect_within_error(got, 0.5 * 2.0 * std::exp(-b0 * far), scattered);
}

TEST(SurfaceReference, SurfacesCastShadows) {
  Scene scene;
  scene.medium.set_homogeneous_density(0.3);
  scene.lights.push_back({{0, 0, 4}, {3, 3, 3}, {}});
  scene.environment = even_sky(1.0f);
  const Surface ground;
  const SurfacePoint point = upward(ground);
  const auto behind_wall = [&](double half) {
    scene.surfaces = {wall(2.0, half)};
    return reflected_light(scene, RayCaster(scene.surfaces), point,
                           {.samples = 20'000, .far = 6.0});
  };
  const ReflectedLight small = behind_wall(0.5);
  const ReflectedLight large = behind_wall(5.0);
  scene.environment.reset();
  scene.lights[0].on = false;
  EXPECT_GT(small.attenuated.x, large.attenuated.x);
  EXPECT_GT(small.scattered.x, 2.0 * large.scattered.x);
  EXPECT_GT(large.scattered.x, 0.0);
  const ReflectedLight dark = behind_wall(0.5);
  EXPECT_EQ(dark.attenuated + dark.scattered, glm::dvec3(0.0));
}

TEST(SurfaceReference, ErrorFallsWithTheRootOfTheSamples) {
  const Surface surface;
  Scene scene;
  scene.medium.set_homogeneous_density(0.4);
  scene.lights.push_back({{1.0, 0.5, 2.0}, {3, 3, 3}, {}});
  scene.medium.append({{0.5, 0.0, 0.5}, 0.3, 2.0});
  const auto at = [&](std::size_t samples, std::uint64_t seed) {
    return reflected_light(scene, RayCaster({}), upward(surface),
                           {.samples = samples, .seed = seed});
  };
  const double reference = at(500'000, 999).scattered.x;
  std::array<double, 2> rms{};
  const std::array<std::size_t, 2> samples = {500, 8000};
  for (std::size_t k = 0; k < samples.size(); ++k) {
    constexpr int runs = 100;
    double squares = 0.0;
    double claimed = 0.0;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
      const ReflectedLight light = at(samples[k], seed);
      squares += std::pow(light.scattered.x - reference, 2) / runs;
      claimed += std::pow(light.error.x, 2) / runs;
    }
    rms[k] = std::sqrt(squares);
    // The reported error matches the actual one, which 100 runs estimate to 7%.
    EXPECT_NEAR(std::sqrt(claimed) / rms[k], 1.0, 0.25);
  }
  EXPECT_NEAR(rms[0] / rms[1], 4.0, 1.0) << "16 times the samples";
}

TEST(SurfaceReference, MatchesAFrameForPointLights) {
  Scene scene = seen_by({{0.5, 0.1, 2}, {0, 0, 0}, {0, 1, 0}, 1.0}, {1, 1});
  scene.lights.push_back({{-0.5, 0.0, 2}, {3, 3, 3}, {}});
  scene.surfaces = {wall(0.0, 1.0, 0.2)};
  Material& material = scene.surfaces[0].material;
  material.type = Material::Type::phong;
  material.specular = {0.1, 0.4, 0.7};
  material.exponent = 40.0;
  const RayCaster ray_caster(scene.surfaces);
  const glm::dvec3 w = glm::normalize(scene.camera.target - scene.camera.eye);
  const SurfaceHit hit = ray_caster.first_hit(scene.camera.eye, w);
  ASSERT_TRUE(hit);
  const SurfacePoint point = ray_caster.point(hit, scene.camera.eye, w, scene.surfaces);
  const glm::dvec3 reference = reflected_light(scene, ray_caster, point, {.samples = 2}).attenuated;
  const Frame frame = render_frame(scene, paper_settings);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(frame.beauty[static_cast<std::size_t>(c)], reference[c], 1e-5 * reference[c]);
  }
  EXPECT_GT(reference.z, 5.0 * reference.x) << "a highlight";
}

// The light that eq. 27 scatters onto a ball from a smooth sky, against the reference. The spread
// of distant light leaves only the bands; the paper takes that of a light near by, at depth 1.
TEST(SurfaceModel, DistantSpreadMatchesTheReference) {
  struct Row {
    double T;
    double paper_error;  // relative rms over the ball
  };
  const Row rows[] = {{0.1, 0.38}, {1.0, 0.70}, {3.0, 1.45}};
  auto sky = std::make_shared<RadianceMap>(RadianceMap{64, 32, {}});
  for (int i = 0; i < 64 * 32; ++i) {
    const glm::dvec3 d = map_direction(*sky, {i % 64 + 0.5, i / 64 + 0.5});
    sky->pixels.emplace_back(glm::dvec3(1.0 + 0.8 * d.y + 0.3 * d.x * d.z));
  }
  Scene scene;
  scene.environment.emplace().map = sky;
  const Surface surface;
  const double far = 10.0;
  const ShVector<glm::dvec3> L = environment_sh(*scene.environment, 6);
  for (const Row& row : rows) {
    scene.medium.set_homogeneous_density(row.T / far);
    double squares = 0.0;
    double error = 0.0;
    double paper_error = 0.0;
    for (const glm::dvec3& n :
         {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0.6, 0, 0.8)}) {
      SurfacePoint point = upward(surface);
      point.normal = point.to_eye = n;
      const ReflectedLight reference =
          reflected_light(scene, RayCaster({}), point, {.samples = 120'000, .far = far});
      const auto model = [&](const ZonalSh<double>& spread) {
        const auto light = sh_convolve(incident_environment(L, row.T, spread), clamped_cosine_sh());
        const auto unscattered = sh_convolve(L, clamped_cosine_sh());
        return 0.5 / pi *
               (sh_evaluate(light, n).x - std::exp(-row.T) * sh_evaluate(unscattered, n).x);
      };
      squares += reference.scattered.x * reference.scattered.x;
      error += std::pow(model(SpreadTable::distant()(row.T)) - reference.scattered.x, 2);
      paper_error += std::pow(model(paper_point_spread_sh) - reference.scattered.x, 2);
    }
    EXPECT_LT(std::sqrt(error / squares), 0.01) << row.T;
    EXPECT_NEAR(std::sqrt(paper_error / squares), row.paper_error, 0.02) << row.T;
  }
}

}  // namespace
}  // namespace brume
