#include "render/deep/deep_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

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

// The largest differences from a flat frame of what is in front of its surfaces.
struct HeldOutError {
  double transmittance = 0.0;
  double airlight = 0.0;  // relative to the pixel's own without holdout, or the frame's rms
};
HeldOutError held_out_error(const DeepFrame& deep, const Frame& wall, double scale) {
  HeldOutError error;
  for (std::size_t i = 0; i < deep.count(); ++i) {
    const auto samples = deep.pixel(i);
    const HeldOut seen =
        held_out(samples.data(), samples.size(), static_cast<double>(wall.depth[i]));
    const HeldOut all = held_out(samples.data(), samples.size(), 1e20);
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
    const HeldOut all = held_out(samples.data(), samples.size(), 2e30);
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
  mirror.material.type = Material::Type::metallic_roughness;
  mirror.material.metallic_roughness.roughness = 0.1;
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

}  // namespace
}  // namespace brume
