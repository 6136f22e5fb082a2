// Noise that bends view rays: section 5.5 of the paper, see core/scene/ray_noise.h.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/reference/airlight_integral.h"
#include "render/renderer.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/errors/fog_errors.h"

namespace brume {
namespace {

Noise noise(double amplitude, double frequency, std::int64_t seed = 0) {
  return {.amplitude = amplitude, .frequency = frequency, .seed = seed};
}

Scene noisy(Scene scene, double amplitude, double frequency = 2.0, std::int64_t seed = 0) {
  scene.optics.noise = noise(amplitude, frequency, seed);
  return scene;
}

Settings method(AirlightMethod airlight) {
  return {.airlight = airlight};
}

double mean_depth(const Frame& frame) {
  double sum = 0.0;
  for (const float t : frame.transmittance) sum -= std::log(static_cast<double>(t));
  return sum / static_cast<double>(frame.transmittance.size());
}

// Seen from afar: from near, a cloud that is shifted towards the eye looks larger.
TEST(Noise, ChangesThePictureButNotTheMeanDepth) {
  Scene scene = cloud_scene(30, 1.0);
  scene.camera.eye.z = 40.0;
  scene.camera.vertical_fov = 6.0;
  scene.film = {64, 64};
  const Settings settings = method(AirlightMethod::paper);
  const Frame still = render_frame(scene, settings);
  for (const double amplitude : {0.1, 0.3, 0.5}) {
    for (const double frequency : {0.3, 1.0, 2.0, 5.0}) {
      for (const std::int64_t seed : {1, 2, 3, 4}) {
        SCOPED_TRACE(testing::Message() << amplitude << ' ' << frequency << ' ' << seed);
        const Frame bent = render_frame(noisy(scene, amplitude, frequency, seed), settings);
        EXPECT_NEAR(mean_depth(bent) / mean_depth(still), 1.0, 0.02);
        EXPECT_GT(rel_rmse(bent.transmittance, still.transmittance), 0.02 * amplitude);
      }
    }
  }
}

TEST(Noise, SlicedConvergesToTheReference) {
  for (const Scene& scene :
       {noisy(cloud_scene(30, 1.0), 0.3), noisy(cloud_scene(30, 1.0), 0.5),
        noisy(cloud_scene(30, 1.0), 0.4, 8.0), noisy(cloud_scene(300, 3.0), 0.4),
        noisy(eye_inside(), 0.4), noisy(cut_by_a_surface(), 0.4)}) {
    const Frame reference = render_frame(scene, method(AirlightMethod::reference));
    const Frame coarse = render_frame(scene, sliced_settings({}, 24));
    const Frame fine = render_frame(scene, sliced_settings({}, 96));
    const double coarse_error = rel_rmse(coarse.airlight, reference.airlight);
    const double fine_error = rel_rmse(fine.airlight, reference.airlight);
    EXPECT_LT(coarse_error, 0.001);
    EXPECT_LT(fine_error, 0.0003);
    for (std::size_t i = 0; i < reference.transmittance.size(); ++i) {
      ASSERT_NEAR(coarse.transmittance[i], reference.transmittance[i], 1e-3);
    }
  }
}

TEST(Noise, PaperInSimdIsThePlainFrame) {
  for (const Scene& scene : {noisy(cloud_scene(300, 1.0), 0.4), noisy(eye_inside(), 0.4),
                             noisy(cut_by_a_surface(), 0.4, 20.0)}) {
    for (const bool improved : {false, true}) {
      Settings settings = method(AirlightMethod::paper);
      settings.paper = {improved, improved};
      settings.depth_error = 1e-7;  // culling is not the same in both
      const Frame fast = render_frame(scene, settings);
      settings.precision = Settings::Precision::plain_double;
      const Frame plain = render_frame(scene, settings);
      EXPECT_LT(rel_rmse(fast.airlight, plain.airlight), 2e-5);
      EXPECT_LT(rel_rmse(fast.transmittance, plain.transmittance), 2e-5);
    }
  }
}

// Along one line the medium is one, wherever on it the eye is and which way it looks.
TEST(Noise, IsFixedInTheWorld) {
  const Scene scene = cloud_scene(30, 1.0);
  const GaussianTerms<double> gaussians(scene.medium);
  const RayNoise displacement(noise(0.5, 2.0), 0.0);
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 w = glm::normalize(random.point(1.0));
    const glm::dvec3 eye = random.point(0.7) - 6.0 * w;
    const auto depth = [&](double from, double to) {
      const glm::dvec3 along = from < to ? w : -w;
      return ViewRayMedium<double>(gaussians.all(), 0.0, eye + from * w, along, 1e9, displacement)
          .depth(std::abs(to - from));
    };
    const double whole = depth(0.0, 12.0);
    ASSERT_GT(whole, 1e-4);
    EXPECT_NEAR(depth(0.0, 5.9) + depth(5.9, 12.0), whole, 1e-12);
    EXPECT_NEAR(depth(12.0, 0.0), whole, 1e-12);
  }
}

// A small step of the eye changes the picture little, in proportion: nothing jumps.
TEST(Noise, IsContinuousWhenTheCameraMoves) {
  const Scene scene = noisy(cloud_scene(30, 3.0), 0.5, 3.0);
  Settings settings = method(AirlightMethod::paper);
  settings.precision = Settings::Precision::plain_double;
  settings.depth_error = 1e-7;
  Renderer renderer;
  const auto seen_from = [&](double step) {
    Camera camera = scene.camera;
    camera.eye += step * glm::dvec3(1.0, 0.5, -0.7);
    return renderer.render(scene, camera, scene.film, settings)->transmittance;
  };
  const auto still = seen_from(0.0);
  const auto max_change = [&](double step) {
    const auto moved = seen_from(step);
    double result = 0.0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      result = std::max(result, std::abs(static_cast<double>(moved[i] - still[i])));
    }
    return result;
  };
  const double far = max_change(1e-2);
  const double near = max_change(1e-3);
  EXPECT_LT(far, 0.05);
  EXPECT_LT(near, 0.15 * far);
  EXPECT_GT(near, 0.05 * far);
}

TEST(Noise, MovesWithTimeAndRenewsNoTables) {
  Scene scene = noisy(cloud_scene(30, 1.0), 0.4);
  const Settings settings = sliced_settings({}, 16);
  Renderer renderer;
  const auto frame = [&](double time) {
    scene.time = time;
    return render_frame(renderer, scene, settings);
  };
  const Frame calm = frame(0.0);
  EXPECT_EQ(frame(3.0).beauty, calm.beauty) << "no wind";
  scene.optics.noise.velocity = {0.2, 0.0, 0.0};
  EXPECT_EQ(frame(0.0).beauty, calm.beauty);
  const Frame later = frame(1.0);
  EXPECT_NE(later.beauty, calm.beauty);
  EXPECT_EQ(later.time, 1.0);
  EXPECT_EQ(later.statistics.light_pairs, 0u);
  EXPECT_EQ(later.beauty, render_frame(scene, settings).beauty) << "a renderer with a past";
}

// `brume bench` reports errors of fog besides its speed.

TEST(FogErrors, InscatteringIsExactInThinFogOnly) {
  const std::vector<InscatteringRow> rows = measure_inscattering();
  ASSERT_FALSE(rows.empty());
  for (const InscatteringRow& row : rows) {
    // T e^-T over 1 - e^-T, which is what leaves the eye's side; in the middle of the Gaussian the
    // sky is dimmed on its way there, so single scattering gives less than that.
    EXPECT_GT(row.share, row.depth / std::expm1(row.depth)) << row.depth;
    EXPECT_LT(row.share, 1.0) << row.depth;
  }
}

TEST(FogErrors, FewerPixelsChangeLittle) {
  const std::vector<ScaleRow> rows = measure_scales();
  ASSERT_FALSE(rows.empty());
  for (const ScaleRow& row : rows) {
    const double share = 1.0 / (row.scale * row.scale);
    EXPECT_GT(row.computed, share) << row.scene;
    EXPECT_LT(row.computed, 2.0 * share) << row.scene;
    EXPECT_GT(row.change, 0.0) << row.scene;
    EXPECT_LT(row.change, 0.01) << row.scene;
  }
}

// See Noise.ChangesThePictureButNotTheMeanDepth; from near what comes closer looks larger.
TEST(NoiseErrors, PreserveTheMeanOpticalDepth) {
  for (const NoiseDepthRow& row : measure_noise_depths()) {
    EXPECT_LT(row.afar.min, row.afar.max);
    EXPECT_LT(std::max(-row.afar.min, row.afar.max), 0.04) << row.cells;
    EXPECT_LT(std::max(-row.near.min, row.near.max), 0.1) << row.cells;
  }
}

TEST(NoiseErrors, MatchTheFogWithoutNoise) {
  for (const ComparedError& row : measure_noise_errors(60)) {
    EXPECT_LT(row.error.rel_rmse, 1.25 * row.other->rel_rmse) << row.label;
    EXPECT_NE(row.error.rel_rmse, row.other->rel_rmse) << row.label;
  }
}

}  // namespace

}  // namespace brume
