#include "render/cpu/film_airlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/scene/scene_file.h"
#include "render/cpu/film_slices.h"
#include "render/renderer.h"
#include "render/slices/slice_boundaries.h"
#include "tests/render/seams.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

Settings at_scale(int scale, AirlightMethod method = AirlightMethod::sliced, int slices = 64) {
  Settings settings = sliced_settings({}, slices);  // so that slicing differs less than is tested
  settings.airlight = method;
  settings.airlight_scale = scale;
  settings.upsampling_tolerance = 0.01;
  return settings;
}

// Far fog, seen past posts that are thinner than the distance between samples, and a ball.
Scene posts_before_fog() {
  Scene scene = on_film(cloud_scene(40, 2.0), {160, 120});
  // From behind: what the posts shade is not in the fog.
  scene.lights[0].position = {1.0, 2.0, -3.0};
  for (const double x : {-0.9, -0.41, 0.03, 0.52, 0.97}) {
    Surface post = wall(1.2, 0.008, 0.5);
    post.translate = {x, 0.0, 0.0};
    // The wall is square: several above each other make a post.
    for (int k = -40; k <= 40; ++k) {
      post.translate.y = 0.016 * k;
      scene.surfaces.push_back(post);
    }
  }
  scene.surfaces.push_back(ball_surface(24, 0.35, {-0.2, 0.2, 0.3}));
  return scene;
}

struct Errors {
  double relative_rmse = 0.0;
  double max_error = 0.0;  // relative to the greatest value
};

Errors errors(const std::vector<float>& a, const std::vector<float>& b) {
  double max_error = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    max_error =
        std::max(max_error, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return {rel_rmse(a, b), max_error / static_cast<double>(*std::max_element(b.begin(), b.end()))};
}

// The worst pixel counts: a halo is a few bad pixels, which an average forgives.
TEST(AirlightScale, ThinObjectsBeforeFarFogHaveNoHalo) {
  const Scene scene = posts_before_fog();
  for (const AirlightMethod method : {AirlightMethod::sliced, AirlightMethod::paper}) {
    SCOPED_TRACE(to_string(method));
    const Frame full = render_frame(scene, at_scale(1, method));
    for (const int scale : {2, 4}) {
      SCOPED_TRACE(scale);
      const Frame frame = render_frame(scene, at_scale(scale, method));
      const Errors light = errors(frame.airlight, full.airlight);
      EXPECT_LT(light.relative_rmse, 0.005);
      EXPECT_LT(light.max_error, 0.03);
      const Errors taken = errors(frame.transmittance, full.transmittance);
      EXPECT_LT(taken.max_error, 0.03);
      EXPECT_LT(frame.statistics.exact_pixels, full.statistics.exact_pixels * 2 / 3);
    }
  }
}

TEST(AirlightScale, SmoothFogIsAlmostAllInterpolated) {
  Scene scene = on_film(cloud_scene(10, 1.0), {320, 240});
  const Frame full = render_frame(scene, at_scale(1));
  const Frame frame = render_frame(scene, at_scale(4));
  EXPECT_LT(errors(frame.airlight, full.airlight).relative_rmse, 0.004);
  EXPECT_LT(frame.statistics.exact_pixels, full.statistics.exact_pixels / 8);
}

// Steps of a stair, each in front of the next, and a ball: pixels next to a depth edge are
// extrapolated from samples on their side of it.
TEST(AirlightScale, EdgesAreUpsampledFromTheirOwnSide) {
  Scene scene = on_film(cloud_scene(10, 1.0), {480, 360});
  for (int k = 0; k < 12; ++k) {
    Surface step = wall(1.2, 0.1, 0.8 - 0.15 * k);
    step.translate = {0.0, 0.2 * k - 1.1, 0.0};
    scene.surfaces.push_back(step);
  }
  scene.surfaces.push_back(ball_surface(48, 0.35, {0.6, 0.1, 1.2}));
  scene.lights[0].position = {-2.0, 3.0, 4.0};
  // Slicing differs most where steps cast shadows, by up to 4% in a pixel at 64 slices.
  Settings settings = at_scale(4, AirlightMethod::sliced, 128);
  settings.upsampling_tolerance = 0.03;
  const Frame full = render_frame(scene, at_scale(1, AirlightMethod::sliced, 128));
  const Frame frame = render_frame(scene, settings);
  const Errors light = errors(frame.airlight, full.airlight);
  const Errors taken = errors(frame.transmittance, full.transmittance);
  EXPECT_LT(light.relative_rmse, 0.008);
  EXPECT_LT(light.max_error, 0.03);
  EXPECT_LT(taken.max_error, 0.005);
  // 15,599 pixels without local fits, 11,521 with them; 10,920 are samples.
  EXPECT_LT(frame.statistics.exact_pixels, 12'500U);
}

// The last column and row are samples too, wherever they fall.
TEST(AirlightScale, AnyFilmIsCovered) {
  Scene scene = in_fog(posts_before_fog(), 0.01);
  for (const int width : {1, 2, 5, 9}) {
    for (const int height : {1, 4, 8}) {
      scene.film = {width, height};
      const Frame full = render_frame(scene, at_scale(1));
      const Frame frame = render_frame(scene, at_scale(4));
      SCOPED_TRACE(width);
      SCOPED_TRACE(height);
      expect_finite(frame);
      EXPECT_LT(errors(frame.airlight, full.airlight).max_error, 0.1);
    }
  }
}

Frame frame_of(const Scene& scene, int slices, int scale) {
  Settings settings = sliced_settings({}, slices);
  settings.airlight_scale = scale;
  return render_frame(scene, settings);
}

// Slices bend at borders, which shows a little in steps over the pixels of a sample: they are up to
// 1.9 times those within tiles. With separate slices per tile they were 4 to 22 times
// those.
void expect_no_edges(const Seams& seams) {
  EXPECT_LT(seams.ratio(0.75), 2.5);
  EXPECT_LT(seams.ratio(0.9), 2.5);
}

TEST(TileSeams, RandomScenesStepNoMoreAtBordersThanWithinTiles) {
  for (const int scale : {4, 1}) {
    Seams coarse;
    Seams fine;
    for (unsigned seed = 1; seed <= 10; ++seed) {
      Scene scene = seam_scene(seed);
      scene.film = scale == 1 ? Film{120, 96} : Film{240, 192};
      const Frame reference = frame_of(scene, 48, 1);
      coarse.add(find_seams(frame_of(scene, 8, scale), reference, scale));
      fine.add(find_seams(frame_of(scene, 16, scale), reference, scale));
    }
    SCOPED_TRACE(testing::Message() << "scale " << scale);
    EXPECT_GT(coarse.borders.size(), 200U);
    expect_no_edges(coarse);
    expect_no_edges(fine);
  }
}

// The view in which an edge was seen.
TEST(TileSeams, BunnyFogHasNoEdges) {
  const Scene scene = load_scene(sample_scene_file("bunny_fog"));
  Renderer renderer;
  const auto render = [&](int slices, int scale) {
    Settings settings = sliced_settings({}, slices);
    settings.airlight_scale = scale;
    return *renderer.render(scene, scene.camera, {966, 833}, settings);
  };
  expect_no_edges(find_seams(render(12, 4), render(64, 1), 4));
}

// A node between equal tiles has the slices of each.
TEST(MergedSlices, PreserveEqualTiles) {
  const std::vector<float> slices{1.0f, 2.0f, 2.5f, 7.0f};
  const std::array<std::span<const float>, 4> tiles{slices, slices, slices, slices};
  for (std::size_t count = 1; count <= 4; ++count) {
    std::array<float, 8> merged{};
    ASSERT_EQ(merge_slices(std::span(tiles).first(count), merged.data()), 4U);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(merged[k], slices[k]);
  }
}

TEST(MergedSlices, CoverTheMediumInAscendingOrder) {
  const std::vector<float> a{1.0f, 2.0f, 3.0f, 4.0f, 5.0f};
  const std::vector<float> b{0.5f, 7.0f};
  const std::vector<float> c{2.0f, 2.2f, 9.0f};
  const std::array<std::span<const float>, 3> tiles{a, b, c};
  std::array<float, 8> merged{};
  const std::size_t count = merge_slices(tiles, merged.data());
  EXPECT_EQ(count, 4U);  // ten boundaries of three tiles
  EXPECT_EQ(merged[0], 0.5f);
  EXPECT_EQ(merged[count - 1], 9.0f);
  EXPECT_TRUE(std::ranges::is_sorted(std::span(merged).first(count)));
}

// However many lights there are, slices fit where they are kept.
TEST(SliceBoundaries, StayWithinTheirCapacity) {
  for (const int slices : {4, 24, 256}) {
    for (const std::size_t lights : {0U, 1U, 4U, 100U, 400U}) {
      EXPECT_LE(max_boundaries(slices, lights, true), max_slice_boundaries);
    }
  }
  EXPECT_EQ(slices_per_light(24, 1), 24);
  EXPECT_EQ(slices_per_light(24, 4), 6);
  EXPECT_EQ(slices_per_light(24, 30), 6);
}

}  // namespace

}  // namespace brume
