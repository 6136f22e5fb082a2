#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/io/scene/scene_file.h"
#include "render/cpu/film_slices.h"
#include "render/renderer.h"
#include "render/slices/slice_boundaries.h"
#include "tests/render/seams.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

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
      if (scale == 1) scene.film = {120, 96};
      const Frame reference = frame_of(scene, 64, 1);
      coarse.add(find_seams(frame_of(scene, 8, scale), reference, scale));
      fine.add(find_seams(frame_of(scene, 16, scale), reference, scale));
    }
    SCOPED_TRACE(testing::Message() << "scale " << scale);
    EXPECT_GT(coarse.borders.size(), 500U);
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
