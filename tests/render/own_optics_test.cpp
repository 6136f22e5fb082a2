// Gaussians with an albedo of their own, and that shine, as every method sees them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "brume/frame.h"
#include "core/scene/camera_rays.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

const glm::dvec3 red(0.9, 0.3, 0.2);
const glm::dvec3 blue(0.2, 0.6, 0.95);
// Changes the optics of each Gaussian.
template <class OpticsOf>
Scene with_optics(Scene scene, OpticsOf&& optics_of) {
  std::size_t index = 0;
  scene.medium = scene.medium.changed(scene.medium.homogeneous_density(), [&](Gaussian g) {
    g.optics = optics_of(index++);
    return g;
  });
  return scene;
}

// Every third is red, every third blue.
Scene coloured(double depth, int film_width = 24) {
  Scene scene = on_film(cloud_scene(20, depth), {film_width, film_width * 3 / 4});
  return with_optics(scene, [](std::size_t i) {
    return i % 3 == 0 ? GaussianOptics{red} : i % 3 == 1 ? GaussianOptics{blue} : GaussianOptics{};
  });
}

// Every fourth shines, too.
Scene glowing(double depth, int film_width = 24) {
  const Scene scene = coloured(depth, film_width);
  return with_optics(scene, [&](std::size_t i) {
    GaussianOptics optics = scene.medium.optics(i);
    if (i % 4 == 0) optics.emission = {3.0, 1.0, 0.2};
    return optics;
  });
}

Scene one_gaussian(double depth, const GaussianOptics& optics, double radius = 0.6) {
  Scene scene = on_film(cloud_scene(1, 1.0), {24, 18});
  scene.lights.clear();
  scene.medium = {};
  const double density = depth / (radius * std::sqrt(std::numbers::pi));
  scene.medium.append({{0.1, 0.0, 0.0}, radius, density, optics});
  return scene;
}

TEST(OwnOptics, WhiteIsPlain) {
  Scene plain = on_film(in_fog(cloud_scene(20, 2.0), 0.03), {24, 18});
  plain.surfaces = {wall(-1.0, 1.5)};
  const Scene white =
      with_optics(plain, [](std::size_t) { return GaussianOptics{glm::dvec3(1.0)}; });
  ASSERT_TRUE(white.medium.has_albedos());
  for (const Settings& settings :
       {reference_settings(1e-3), sliced(24), all_orders(24), path_traced(4)}) {
    const Frame a = render_frame(plain, settings);
    const Frame b = render_frame(white, settings);
    EXPECT_EQ(a.airlight, b.airlight);
    // Put together from groups, which rounds.
    EXPECT_LT(rel_rmse(b.beauty, a.beauty), 1e-6);
  }
}

// A medium of one albedo is one whose Gaussians all have it.
TEST(OwnOptics, TheSameForAllIsTheMediums) {
  Scene medium = on_film(cloud_scene(20, 2.0), {24, 18});
  medium.optics.albedo = {0.9, 0.6, 0.6};
  Scene own =
      with_optics(medium, [&](std::size_t) { return GaussianOptics{medium.optics.albedo}; });
  own.optics.albedo = glm::dvec3(0.8);  // of no Gaussian
  for (const Settings& settings : {reference_settings(), sliced(24), all_orders(24)}) {
    const Frame a = render_frame(medium, settings);
    const Frame b = render_frame(own, settings);
    EXPECT_LT(rel_rmse(b.airlight, a.airlight), 1e-4);
    EXPECT_LT(rel_rmse(b.beauty, a.beauty), 1e-4);
    EXPECT_LT(rel_rmse(b.transmittance, a.transmittance), 1e-5);
  }
}

// Radiance times opacity: exact for each ray.
TEST(OwnOptics, EmissionAloneIsItsClosedForm) {
  const glm::dvec3 emission(5.0, 2.0, 0.5);
  for (const double depth : {0.01, 1.0, 40.0}) {
    for (const glm::dvec3& albedo : {glm::dvec3(1.0), glm::dvec3(0.5, 0.8, 0.01)}) {
      const Scene scene = one_gaussian(depth, {albedo, emission});
      const CameraRays rays(scene.camera, scene.film);
      std::vector<float> expected;
      for (int y = 0; y < scene.film.height; ++y) {
        for (int x = 0; x < scene.film.width; ++x) {
          const glm::dvec3 w = glm::normalize(rays.direction(x + 0.5, y + 0.5));
          const double scattering = plain_depth(scene.medium, scene.camera.eye, w, 100.0);
          for (int c = 0; c < 3; ++c) {
            expected.push_back(
                static_cast<float>(emission[c] * -std::expm1(-scattering / albedo[c])));
          }
        }
      }
      const auto error = [&](const Settings& settings) {
        return rel_rmse(render_frame(scene, settings).airlight, expected);
      };
      EXPECT_LT(error(reference_settings()), 1e-5) << depth;
      EXPECT_LT(error(sliced(24)), 2e-3) << depth;
    }
  }
}

// The Gaussian scatters next to nothing, since paths are of all orders.
TEST(OwnOptics, PathsOfEmissionAloneAreItsClosedForm) {
  const GaussianOptics optics{glm::dvec3(1e-6), glm::dvec3(5.0, 2.0, 0.5)};
  const Scene scene = one_gaussian(1e-6, optics);
  const Frame truth = render_frame(scene, reference_settings());
  const Difference paths =
      difference(render_frame(scene, path_traced(64)).airlight, truth.airlight);
  EXPECT_LT(paths.relative_rmse, 1e-4);
}

// A hot dense Gaussian is a wall of its source's radiance.
TEST(OwnOptics, DenseEmissionIsItsRadiance) {
  const glm::dvec3 emission(5.0, 2.0, 0.5);
  const Scene scene = one_gaussian(1e4, {std::nullopt, emission});
  const Frame frame = render_frame(scene, sliced(24));
  const std::size_t middle = 3 * (9 * 24 + 12);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(frame.airlight[middle + c], emission[static_cast<int>(c)],
                1e-3 * emission[static_cast<int>(c)]);
  }
}

// The light that a ray scatters and emits, by small steps.
glm::dvec3 integral(const Scene& scene, const glm::dvec3& w) {
  const double b0 = scene.medium.homogeneous_density();
  const Light& light = scene.lights[0];
  // Scattering, extinction and emission at x.
  const auto at = [&](const glm::dvec3& x) {
    std::array<glm::dvec3, 3> sums{glm::dvec3(b0), b0 / scene.optics.albedo, glm::dvec3(0.0)};
    for (std::size_t i = 0; i < scene.medium.size(); ++i) {
      const Gaussian g = scene.medium.gaussian(i);
      const glm::dvec3 q = (x - g.center) / g.radius;
      const double b = g.density * std::exp(-glm::dot(q, q));
      const glm::dvec3 extinction = b / g.optics.albedo.value_or(scene.optics.albedo);
      sums[0] += b;
      sums[1] += extinction;
      sums[2] += extinction * g.optics.emission;
    }
    return sums;
  };
  glm::dvec3 depth(0.0);
  glm::dvec3 sum(0.0);
  constexpr double gaussians_end = 8.0;
  double t = 0.0;
  while (t < 400.0) {
    const double step = t < gaussians_end ? 0.005 : 0.02 * t;
    const glm::dvec3 x = scene.camera.eye + (t + 0.5 * step) * w;
    t += step;
    const auto [scattering, extinction, emission] = at(x);
    const glm::dvec3 to_light = light.position - x;
    const double r = glm::length(to_light);
    glm::dvec3 light_depth(0.0);
    constexpr int light_steps = 200;
    for (int k = 0; k < light_steps; ++k) {
      light_depth += r / light_steps * at(x + (k + 0.5) / light_steps * to_light)[1];
    }
    const glm::dvec3 lit =
        scattering * light.intensity * glm::exp(-light_depth) / (4.0 * std::numbers::pi * r * r);
    sum += step * glm::exp(-depth - 0.5 * step * extinction) * (lit + emission);
    depth += step * extinction;
  }
  return sum;
}

TEST(OwnOptics, ReferenceIsTheIntegral) {
  Scene scene = in_fog(glowing(2.0, 16), 0.02);
  scene.optics.albedo = {0.95, 0.9, 0.85};
  const Frame frame = render_frame(scene, reference_settings());
  const CameraRays rays(scene.camera, scene.film);
  for (const glm::ivec2 pixel : {glm::ivec2(8, 6), {6, 5}, {10, 7}, {7, 8}}) {
    const glm::dvec3 w = glm::normalize(rays.direction(pixel.x + 0.5, pixel.y + 0.5));
    const glm::dvec3 expected = integral(scene, w);
    for (int c = 0; c < 3; ++c) {
      const auto at = static_cast<std::size_t>(3 * (pixel.y * 16 + pixel.x) + c);
      EXPECT_NEAR(frame.airlight[at], expected[c], 2e-3 * expected[c])
          << pixel.x << ", " << pixel.y << " channel " << c;
    }
  }
}

TEST(OwnOptics, SlicedMatchesTheReference) {
  for (const double depth : {0.3, 3.0, 20.0}) {
    for (const double b0 : {0.0, 0.03}) {
      Scene scene = in_fog(glowing(depth, 16), b0);
      scene.optics.anisotropy = b0 > 0.0 ? 0.5 : 0.0;
      scene.optics.albedo = {0.95, 0.9, 0.9};
      const Frame truth = render_frame(scene, reference_settings(1e-4));
      const Frame frame = render_frame(scene, sliced(24));
      EXPECT_LT(rel_rmse(frame.airlight, truth.airlight), 0.01) << depth;
      if (b0 > 0.0) continue;
      EXPECT_LT(rel_rmse(frame.transmittance, truth.transmittance), 1e-3);
    }
  }
}

TEST(OwnOptics, UnderAnEnvironmentSlicedMatchesTheReference) {
  Scene scene = coloured(2.0, 8);
  scene.lights.clear();
  scene.environment = even_sky(1.0f);
  const Frame truth = render_frame(scene, reference_settings(1e-3));
  EXPECT_LT(rel_rmse(render_frame(scene, sliced(24)).airlight, truth.airlight), 0.02);
}

TEST(OwnOptics, AllOrdersMatchPaths) {
  struct LitFog {
    double b0, anisotropy;
    bool has_wall, is_lit;
  };
  for (const auto& [b0, anisotropy, has_wall, is_lit] :
       {LitFog{0.0, 0.5, true, true}, LitFog{0.05, 0.0, false, false}}) {
    Scene scene = in_fog(glowing(3.0, 12), b0);
    scene.optics.albedo = glm::dvec3(0.8);  // paths end sooner
    scene.optics.anisotropy = anisotropy;
    if (has_wall) scene.surfaces = {wall(-1.2, 1.5)};
    if (!is_lit) scene.lights.clear();
    // On fewer nodes the light of small Gaussians is 10% off.
    expect_all_orders_match_paths(scene, "anisotropy " + std::to_string(anisotropy),
                                  {.nodes = 50'000, .directions = 48});
  }
}

// Emission lights its surroundings, by all orders only.
TEST(OwnOptics, EmissionLightsSurfaces) {
  Scene scene = one_gaussian(0.5, {std::nullopt, glm::dvec3(10.0, 4.0, 1.0)});
  scene.surfaces = {wall(-1.0, 2.0)};
  const Frame truth = traced_truth(scene, 512);
  const Difference beauty = difference(render_frame(scene, all_orders(24)).beauty, truth.beauty);
  EXPECT_LT(beauty.relative_rmse, 0.05);
  EXPECT_LT(std::abs(beauty.bias), 0.02);
}

// One that hardly attenuates anything, on a wall, and the light that it is as a point.
struct Glow {
  Scene scene, lit;

  // In a cloud, too, which makes the grid as coarse as a scene's.
  explicit Glow(bool has_cloud)
      : scene(one_gaussian(0.01, {std::nullopt, glm::dvec3(2000.0)}, 0.03)) {
    if (has_cloud) scene.medium.append({{0.0, 0.0, 0.0}, 0.8, 0.2});
    scene.surfaces = {wall(-1.0, 2.0)};
    lit = with_optics(scene, [](std::size_t) { return GaussianOptics{}; });
    const Gaussian g = scene.medium.gaussian(0);
    const double volume = std::pow(std::sqrt(std::numbers::pi) * g.radius, 3.0);
    lit.lights = {{g.center, g.density * volume * g.optics.emission}};
  }

  // Where the Gaussian itself is not seen.
  [[nodiscard]] Difference on_wall(const Settings& settings) const {
    const Frame frame = render_frame(scene, settings);
    const Frame expected = render_frame(lit, settings);
    std::array<std::vector<float>, 2> radiance;
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (frame.airlight[3 * i] > 2.0f * expected.airlight[3 * i] + 1e-3f) continue;
      radiance[0].push_back(frame.beauty[4 * i]);
      radiance[1].push_back(expected.beauty[4 * i]);
    }
    EXPECT_GT(radiance[0].size(), frame.depth.size() / 2);
    return difference(radiance[0], radiance[1]);
  }
};

// In a few hundred directions their light would be in patches: 24%. A surface finds it between
// nodes, in four bands.
TEST(OwnOptics, SmallOnesLightAsPoints) {
  EXPECT_LT(Glow(true).on_wall(sliced(24, Scattering::multiple)).relative_rmse, 0.08);
}

// The grid ends soon beyond the Gaussian; as at its border the wall would be 7 times too bright.
TEST(OwnOptics, SmallOnesLightWhatIsFarBeyondTheGrid) {
  EXPECT_LT(std::abs(Glow(false).on_wall(all_orders(24)).bias), 0.05);
}

// Collisions alone would hardly ever find them.
TEST(OwnOptics, PathsFindSmallOnes) {
  EXPECT_LT(Glow(false).on_wall(path_traced(64)).relative_rmse, 0.02);
}

// Fog far beside it, on grids as coarse as it is large: brighter by 64% where slices are as long as
// it is far away.
TEST(OwnOptics, EmissionLightsFogAround) {
  Scene scene =
      on_film(in_fog(one_gaussian(0.01, {std::nullopt, glm::dvec3(2000.0)}, 0.3), 0.01), {6, 4});
  scene.optics.albedo = glm::dvec3(0.9);  // paths end sooner
  scene.camera = {{0, 1, 5}, {1.5, 1, 0}, {0, 1, 0}, 15.0};
  const Frame truth = traced_truth(scene, 4096);
  // One per cent is the noise of the paths.
  EXPECT_LT(std::abs(difference(render_frame(scene, all_orders(24)).airlight, truth.airlight).bias),
            0.05);
}

// The grid widens what is smaller than its nodes are apart; of an opaque one it must not let out
// what is inside. A cloud beside it makes the grid as coarse as a scene's.
TEST(OwnOptics, SmallOpaqueEmissionLightsNoMoreThanItsSurface) {
  const GaussianOptics hot{glm::dvec3(0.2), glm::dvec3(200.0)};
  for (const double depth : {0.1, 2.0}) {
    Scene scene = one_gaussian(depth, hot, 0.03);
    scene.medium.append({{0.0, 0.0, 0.0}, 0.8, 0.2});
    scene.surfaces = {wall(-1.0, 2.0)};
    const Frame truth = traced_truth(scene, 1024);
    const Difference beauty = difference(render_frame(scene, all_orders(24)).beauty, truth.beauty);
    // The light of few directions is in patches.
    EXPECT_LT(std::abs(beauty.bias), 0.05) << depth;
  }
}

TEST(OwnOptics, AreLeftOutByThePaperWithAWord) {
  const Scene scene = glowing(1.0);
  const Scene plain = with_optics(scene, [](std::size_t) { return GaussianOptics{}; });
  const Frame frame = render_frame(scene, paper_settings);
  EXPECT_EQ(frame.airlight, render_frame(plain, paper_settings).airlight);
  EXPECT_TRUE(is_left_out(frame, "one albedo and no emission"));
}

struct HardOptics {
  double albedo, emission, depth;
};

TEST(OwnOptics, HardCasesAreFinite) {
  const Settings small_grid = all_orders(8, {.nodes = 1000, .directions = 32});
  for (const auto& [albedo, emission, depth] :
       {HardOptics{1e-6, 1e20, 1e8}, {1e-6, 0.0, 1e-9}, {1.0, 1e20, 1e-9}, {1.0, 1e-20, 1e8}}) {
    Scene scene = on_film(in_fog(cloud_scene(3, depth), depth > 1.0 ? 0.0 : 0.1), {4, 3});
    scene.surfaces = {wall(-1.0, 1.5)};
    scene.optics.albedo = {1e-6, 1.0, 0.5};
    scene = with_optics(scene, [&](std::size_t i) {
      return i == 0 ? GaussianOptics{} : GaussianOptics{glm::dvec3(albedo), glm::dvec3(emission)};
    });
    for (const Settings& settings :
         {sliced(8), small_grid, reference_settings(1e-2), path_traced(2)}) {
      expect_finite(render_frame(scene, settings));
    }
  }
}

}  // namespace
}  // namespace brume
