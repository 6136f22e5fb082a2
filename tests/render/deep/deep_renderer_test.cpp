#include "render/deep/deep_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "render/deep/deep_samples.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

double rms(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value) * static_cast<double>(value);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// A deep frame in memory.
class DeepFrame {
 public:
  DeepFrame(const Scene& scene, const Settings& settings, double error, const Frame& flat) {
    const auto take = [&](const DeepRows& rows) {
      next_row_ok_ = next_row_ok_ && rows.first * scene.film.width == static_cast<int>(count());
      for (const std::uint32_t samples : rows.counts) first_.push_back(first_.back() + samples);
      samples_.insert(samples_.end(), rows.samples.begin(), rows.samples.end());
    };
    const DeepSettings deep{settings, error, rms(flat.airlight)};
    statistics_ = render_deep(scene, scene.camera, scene.film, deep, TransferStore(), take).value();
    EXPECT_TRUE(next_row_ok_);
    EXPECT_EQ(statistics_.samples, samples_.size());
    EXPECT_EQ(statistics_.coarse_tiles, 0u);
    EXPECT_EQ(count(), flat.depth.size());
  }

  [[nodiscard]] std::size_t count() const { return first_.size() - 1; }
  [[nodiscard]] std::span<const DeepSample> pixel(std::size_t i) const {
    return std::span(samples_).subspan(first_[i], first_[i + 1] - first_[i]);
  }
  [[nodiscard]] double samples_per_pixel() const {
    return static_cast<double>(samples_.size()) / static_cast<double>(count());
  }

 private:
  bool next_row_ok_ = true;
  std::vector<std::size_t> first_{0};
  std::vector<DeepSample> samples_;
  DeepStatistics statistics_;
};

// The view of samples up to a distance: nothing of a surface there, or behind it.
struct HeldOut {
  glm::dvec3 airlight{0.0};
  glm::dvec3 transmittance{1.0};
};
HeldOut held_out(std::span<const DeepSample> samples, double distance) {
  HeldOut result;
  for (const DeepSample& sample : samples) {
    const double front = static_cast<double>(sample.z);
    const double length = static_cast<double>(sample.z_back) - front;
    if (front >= distance) break;
    const double x = length > 0.0 ? std::min((distance - front) / length, 1.0) : 1.0;
    for (int c = 0; c < 3; ++c) {
      // A sample is homogeneous: its optical depth grows linearly, its light with what it absorbs.
      const double alpha = static_cast<double>(sample.alpha[c]);
      const double alpha_in_front = 1.0 - std::pow(1.0 - alpha, x);
      const double share = alpha > 0.0 ? alpha_in_front / alpha : x;
      result.airlight[c] += result.transmittance[c] * static_cast<double>(sample.color[c]) * share;
      result.transmittance[c] *= 1.0 - alpha_in_front;
    }
  }
  return result;
}

// The largest differences from a flat frame of what is in front of its surfaces.
struct HeldOutError {
  double transmittance = 0.0;
  double airlight = 0.0;  // relative to the pixel's own without holdout, or the frame's rms
};
HeldOutError held_out_error(const DeepFrame& deep, const Frame& wall, double scale) {
  HeldOutError error;
  for (std::size_t i = 0; i < deep.count(); ++i) {
    const auto samples = deep.pixel(i);
    const HeldOut seen = held_out(samples, static_cast<double>(wall.depth[i]));
    const HeldOut all = held_out(samples, 1e20);
    for (int c = 0; c < 3; ++c) {
      const std::size_t at = 3 * i + static_cast<std::size_t>(c);
      error.transmittance =
          std::max(error.transmittance,
                   std::abs(seen.transmittance[c] - static_cast<double>(wall.transmittance[at])));
      error.airlight = std::max(
          error.airlight, std::abs(seen.airlight[c] - static_cast<double>(wall.airlight[at])) /
                              std::max(scale, all.airlight[c]));
    }
  }
  return error;
}

// A cloud whose light is beside the camera, so that walls behind fog cast no shadow on it.
Scene lit_from_the_front(double depth) {
  Scene scene = on_film(cloud_scene(40, depth), {40, 32});
  scene.lights[0].position = {1.0, 1.0, 5.0};
  return scene;
}

constexpr double deep_error = 0.01;
// The slices of a frame with a wall are others: that much they differ.
constexpr double slicing = 0.004;

void expect_walls_match(const Scene& scene) {
  const Settings settings = sliced(64);
  const Frame flat = render_frame(scene, settings);
  const DeepFrame deep(scene, settings, deep_error, flat);
  for (const double z : {0.7, 0.25, 0.0, -0.4, -0.8}) {
    Scene with_wall = scene;
    with_wall.surfaces.push_back(wall(z, 9.0, 0.0));
    const HeldOutError worst =
        held_out_error(deep, render_frame(with_wall, settings), rms(flat.airlight));
    EXPECT_LE(worst.transmittance, deep_error + 1e-3) << z;
    EXPECT_LE(worst.airlight, deep_error + slicing) << z;
  }
}

TEST(DeepRenderer, HeldOutIsTheFrameWithAWall) {
  expect_walls_match(lit_from_the_front(2.0));
}

TEST(DeepRenderer, HeldOutIsTheFrameWithAWallInThickFog) {
  expect_walls_match(in_fog(lit_from_the_front(20.0), 0.05));
}

TEST(DeepRenderer, HeldOutIsTheFrameWithAWallInColour) {
  Scene scene = lit_from_the_front(3.0);
  scene.optics.albedo = {0.9, 0.6, 0.3};
  ASSERT_TRUE(has_colored_alpha(scene));
  expect_walls_match(scene);
}

// Under an environment and many orders of scattering a wall changes the light, but not what is at
// the end.
void expect_flattened_is_flat(Scene scene, const Surface& behind = wall(-0.3, 0.6)) {
  scene.environment = Environment{.file = {}, .map = constant_sky(0.3f), .intensity = 1.0};
  scene.optics.anisotropy = 0.3;
  scene.lights[0].intensity = glm::dvec3(100.0);
  scene.surfaces.push_back(behind);
  Settings settings = all_orders(64, {.nodes = 2000, .directions = 32});
  const Frame flat = render_frame(scene, settings);
  const DeepFrame deep(scene, settings, deep_error, flat);
  const double scale = rms(flat.beauty);
  for (std::size_t i = 0; i < deep.count(); ++i) {
    const auto samples = deep.pixel(i);
    const HeldOut all = held_out(samples, 2e30);
    double alpha = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double beauty = flat.beauty[4 * i + static_cast<std::size_t>(c)];
      EXPECT_NEAR(all.airlight[c], beauty, slicing * std::max(scale, beauty)) << i;
      alpha += (1.0 - all.transmittance[c]) / 3.0;
    }
    EXPECT_NEAR(alpha, flat.beauty[4 * i + 3], 1e-3) << i;
    // A surface is a point, at its depth.
    if (std::isfinite(flat.depth[i])) {
      EXPECT_EQ(samples.back().z, flat.depth[i]);
      EXPECT_EQ(samples.back().z_back, flat.depth[i]);
      EXPECT_EQ(samples.back().mean_alpha, 1.0f);
    }
  }
}

TEST(DeepRenderer, FlattenedIsTheFlatFrame) {
  expect_flattened_is_flat(lit_from_the_front(3.0));
}

TEST(DeepRenderer, FlattenedIsTheFlatFrameOfAMirror) {
  Surface mirror = wall(-0.3, 0.6);
  mirror.material = metallic_roughness(glm::dvec3(1.0), 1.0, 0.1);
  expect_flattened_is_flat(lit_from_the_front(3.0), mirror);
}

// Depths are along the axis, from the plane of the eye on.
TEST(DeepRenderer, FlattenedIsTheFlatFrameOfAnOrthographicCamera) {
  Scene scene = lit_from_the_front(3.0);
  scene.camera.height = 2.6;
  expect_flattened_is_flat(scene);
}

// Part of the cloud stands in a ball of fog.
TEST(DeepRenderer, FlattenedIsTheFlatFrameOfABallOfFog) {
  Scene scene = in_fog(lit_from_the_front(1.0), 0.5);
  scene.optics.extent = 0.8;
  expect_flattened_is_flat(scene);
}

TEST(DeepRenderer, TakesFewerSamplesForALargerError) {
  const Scene scene = lit_from_the_front(2.0);
  const Settings settings = sliced(24);
  const Frame flat = render_frame(scene, settings);
  const double coarse = DeepFrame(scene, settings, 0.05, flat).samples_per_pixel();
  const double fine = DeepFrame(scene, settings, 0.002, flat).samples_per_pixel();
  EXPECT_LT(coarse, 4.0);
  EXPECT_GT(fine, 2.0 * coarse);
}

TEST(DeepRenderer, StopsAndLeavesNoFile) {
  Scene scene = lit_from_the_front(2.0);
  std::stop_source stop;
  stop.request_stop();
  const Job job{stop.get_token(), {}};
  const auto take = [](const DeepRows&) {};
  EXPECT_FALSE(render_deep(scene, scene.camera, scene.film, {}, TransferStore(), take, job));
}

TEST(DeepRenderer, WithoutFogSurfacesAreLeft) {
  Scene scene = lit_from_the_front(2.0);
  scene.medium = Medium();
  scene.surfaces.push_back(wall(0.0, 0.5));
  const Frame flat = render_frame(scene, sliced(24));
  const DeepFrame deep(scene, sliced(24), deep_error, flat);
  for (std::size_t i = 0; i < deep.count(); ++i) {
    ASSERT_EQ(deep.pixel(i).size(), std::isfinite(flat.depth[i]) ? 1u : 0u);
    if (deep.pixel(i).empty()) continue;
    EXPECT_NEAR(deep.pixel(i)[0].color.r, flat.beauty[4 * i], 1e-6 + 1e-5 * flat.beauty[4 * i]);
  }
  scene.surfaces[0].holdout = true;
  const DeepFrame held_out(scene, sliced(24), deep_error, flat);
  for (std::size_t i = 0; i < held_out.count(); ++i) EXPECT_TRUE(held_out.pixel(i).empty());
}

TEST(DeepRenderer, ARegionHasTheSamplesOfTheWholeFrame) {
  Scene scene = on_film(cut_by_a_surface(), {90, 50});
  const Frame flat = render_frame(scene, sliced(8));
  const DeepFrame whole(scene, sliced(8), deep_error, flat);
  scene.film = film_region(scene.film, {0.3, 0.3}, {0.6, 0.7});
  Frame flat_region = render_frame(scene, sliced(8));
  flat_region.airlight = flat.airlight;  // whose rms the tolerance is relative to
  const DeepFrame region(scene, sliced(8), deep_error, flat_region);
  std::size_t samples = 0;
  for (int y = 0; y < scene.film.height; ++y) {
    for (int x = 0; x < scene.film.width; ++x) {
      const auto found = region.pixel(static_cast<std::size_t>(y * scene.film.width + x));
      const int place = (scene.film.region->y + y) * 90 + scene.film.region->x + x;
      const auto expected = whole.pixel(static_cast<std::size_t>(place));
      samples += found.size();
      ASSERT_EQ(found.size(), expected.size()) << x << ", " << y;
      ASSERT_EQ(std::memcmp(found.data(), expected.data(), found.size_bytes()), 0);
    }
  }
  EXPECT_GT(samples, 1000u);
}

// A ray through Gaussians of optical depth `depth` each, centers 1 u apart, lit with radiance
// 1, 2, 3 times exp(-t): `points` at equal distances from 0 to 4.
RayProfile gaussians(double depth, int count, int points, const glm::dvec3& channels) {
  RayProfile ray;
  glm::dvec3 light(0.0);
  glm::dvec3 last(0.0);
  for (int i = 0; i < points; ++i) {
    const double t = 4.0 * i / (points - 1);
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {
      sum += 0.5 * depth * (std::erf((t - 1.0 - k) / 0.3) - std::erf((-1.0 - k) / 0.3));
    }
    const glm::dvec3 depths = channels * sum;
    const double middle = t - 2.0 / (points - 1);
    for (int c = 0; c < 3; ++c) {
      light[c] += (std::exp(-last[c]) - std::exp(-depths[c])) * (1.0 + c) * std::exp(-middle);
    }
    last = depths;
    ray.add(static_cast<float>(t), depths, light);
  }
  return ray;
}

DeepTolerance tolerance_of(double error, const RayProfile& ray) {
  return {error, error * ray.airlight.back()};
}

// The largest error at a point, in tolerances.
double worst(const RayProfile& ray, const DeepTolerance& tolerance,
             const std::vector<DeepSample>& samples) {
  double worst = 0.0;
  for (std::size_t i = 0; i < ray.size(); ++i) {
    const HeldOut seen = held_out(samples, static_cast<double>(ray.distances[i]));
    for (int c = 0; c < 3; ++c) {
      worst = std::max(
          {worst,
           std::abs(seen.transmittance[c] - ray.transmittance[i][c]) / tolerance.transmittance,
           std::abs(seen.airlight[c] - ray.airlight[i][c]) / tolerance.airlight[c]});
    }
  }
  return worst;
}

// The fewest samples that keep the tolerance: over all ways to cut the ray at its points.
std::size_t fewest(const RayProfile& ray, const DeepTolerance& tolerance) {
  std::vector<std::size_t> count(ray.size(), std::numeric_limits<std::size_t>::max());
  count[0] = 0;
  for (std::size_t b = 1; b < ray.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      RayProfile part;
      for (std::size_t i = a; i <= b; ++i) {
        part.add(ray.distances[i], ray.depths[i] - ray.depths[a],
                 (ray.airlight[i] - ray.airlight[a]) / ray.transmittance[a]);
      }
      std::vector<DeepSample> one;
      fit_deep_samples(part, {1e9, glm::dvec3(1e9)}, one);
      const DeepTolerance scaled{tolerance.transmittance / ray.transmittance[a].x,
                                 tolerance.airlight / ray.transmittance[a].x};
      if (worst(part, scaled, one) <= 1.0 + 1e-6) {
        count[b] = std::min(count[b], count[a] + one.size());
      }
    }
  }
  return count.back();
}

TEST(DeepSamples, OneSampleIsHomogeneousFog) {
  RayProfile ray;
  for (int i = 0; i <= 20; ++i) {
    const double t = 0.1 * i;
    ray.add(static_cast<float>(1.0 + t), glm::dvec3(2.0 * t), glm::dvec3(5.0 * (1 - exp(-2 * t))));
  }
  std::vector<DeepSample> samples;
  fit_deep_samples(ray, {1e-5, glm::dvec3(1e-5)}, samples);
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_FLOAT_EQ(samples[0].z, 1.0f);
  EXPECT_FLOAT_EQ(samples[0].z_back, 3.0f);
  EXPECT_NEAR(samples[0].alpha.g, 1.0 - std::exp(-4.0), 1e-6);
  EXPECT_NEAR(samples[0].color.r, 5.0 * (1.0 - std::exp(-4.0)), 1e-5);
}

TEST(DeepSamples, KeepTheToleranceAndAllOfTheRay) {
  for (const glm::dvec3& channels : {glm::dvec3(1.0), glm::dvec3(1.0, 2.0, 0.3)}) {
    for (const double depth : {0.01, 1.0, 8.0}) {
      for (const double error : {0.1, 0.01, 0.001}) {
        const RayProfile ray = gaussians(depth, 3, 400, channels);
        const DeepTolerance tolerance = tolerance_of(error, ray);
        std::vector<DeepSample> samples;
        fit_deep_samples(ray, tolerance, samples);
        EXPECT_LE(worst(ray, tolerance, samples), 1.0 + 1e-4) << depth << " " << error;
        const HeldOut all = held_out(samples, 1e9);
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(all.airlight[c], ray.airlight.back()[c], 3e-6 * ray.airlight.back()[c]);
          EXPECT_NEAR(all.transmittance[c], ray.transmittance.back()[c], 1e-6);
        }
      }
    }
  }
}

// Ends of samples are exact, so the longest sample each time is the fewest samples, unless a longer
// one fits where a shorter does not.
TEST(DeepSamples, AreFewest) {
  for (const double depth : {0.3, 3.0}) {
    for (const double error : {0.1, 0.01}) {
      const RayProfile ray = gaussians(depth, 3, 41, glm::dvec3(1.0));
      const DeepTolerance tolerance = tolerance_of(error, ray);
      std::vector<DeepSample> samples;
      fit_deep_samples(ray, tolerance, samples);
      EXPECT_LE(samples.size(), fewest(ray, tolerance) + 1) << depth << " " << error;
    }
  }
}

TEST(DeepSamples, LeaveGapsBetweenClouds) {
  RayProfile ray;
  for (const auto& [t, depth] : {std::pair(1.0, 0.0),
                                 {2.0, 0.0},
                                 {3.0, 1.0},
                                 {4.0, 1.0},
                                 {8.0, 1.0},
                                 {9.0, 1.5},
                                 {10.0, 1.5}}) {
    ray.add(static_cast<float>(t), glm::dvec3(depth), glm::dvec3(1.0 - std::exp(-depth)));
  }
  std::vector<DeepSample> samples;
  fit_deep_samples(ray, {1e-3, glm::dvec3(1e-3)}, samples);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].z, 2.0f);
  EXPECT_EQ(samples[0].z_back, 3.0f);
  EXPECT_EQ(samples[1].z, 8.0f);
  EXPECT_EQ(samples[1].z_back, 9.0f);
}

// In float an alpha of nearly 1 is 1, and a volume of it is opaque at its front.
TEST(DeepSamples, StayInsideOpaqueFog) {
  const RayProfile ray = gaussians(200.0, 1, 400, glm::dvec3(1.0));
  const DeepTolerance tolerance = tolerance_of(0.02, ray);
  std::vector<DeepSample> samples;
  fit_deep_samples(ray, tolerance, samples);
  EXPECT_GT(samples.size(), 2u);
  EXPECT_LE(worst(ray, tolerance, samples), 1.0 + 1e-4);
  for (const DeepSample& sample : samples) EXPECT_TRUE(std::isfinite(sample.color.r));
}

TEST(DeepSamples, TellWhatIsBetweenPoints) {
  const double coarse =
      error_between_points(gaussians(2.0, 1, 21, glm::dvec3(1.0)), {0.01, glm::dvec3(0.01)});
  const double fine =
      error_between_points(gaussians(2.0, 1, 41, glm::dvec3(1.0)), {0.01, glm::dvec3(0.01)});
  EXPECT_GT(coarse, 0.5);
  EXPECT_LT(fine, 0.4 * coarse);
}

}  // namespace

}  // namespace brume
