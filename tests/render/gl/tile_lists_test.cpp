// Lists of tiles that are longer than the memory that a work group shares.

#include "render/gl/tile_lists.h"

#include <numeric>
#include <utility>

#include "tests/random.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

// Entries that sort_list.glsl sorts in shared memory.
constexpr std::size_t max_shared = 2048;

// All of them in all of its tiles.
Scene crowded_scene(int gaussians) {
  Random random(11);
  Scene scene;
  scene.film = {24, 12};
  for (int i = 0; i < gaussians; ++i) {
    const glm::dvec3 center = random.point(0.5);
    scene.medium.append({center, random.uniform(1.0, 2.0), 1.0 / gaussians});
  }
  Light light;
  light.position = {3.0, 2.0, 1.0};
  light.intensity = glm::dvec3(30.0, 20.0, 10.0);
  scene.lights.push_back(light);
  return scene;
}

class SortedLists : public GlTest {};

// The order in which list.glsl finds Gaussians is that of the device; here it is as bad as can be.
TEST_F(SortedLists, AscendAtAnyLength) {
  Random random(3);
  const std::vector<std::size_t> counts{
      0, 1, 2, 100, max_shared - 1, max_shared, max_shared + 1, 3000, 5000};
  std::vector<std::uint32_t> offsets{0};
  std::vector<std::uint32_t> entries;
  for (const std::size_t count : counts) {
    std::vector<std::uint32_t> list(count);
    std::iota(list.begin(), list.end(), 7u);
    for (std::size_t i = count; i > 1; --i) {
      std::swap(list[i - 1],
                list[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(i)))]);
    }
    entries.insert(entries.end(), list.begin(), list.end());
    offsets.push_back(static_cast<std::uint32_t>(entries.size()));
  }
  Buffer entry_buffer;
  Buffer offset_buffer;
  entry_buffer.upload(std::span<const std::uint32_t>(entries));
  offset_buffer.upload(std::span<const std::uint32_t>(offsets));
  const Program sort("sort_list.glsl");
  sort.set("tiles", static_cast<unsigned>(counts.size()));
  sort.bind("Entries", entry_buffer);
  sort.bind("Offsets", offset_buffer);
  sort.dispatch_linear(counts.size());
  entry_buffer.download(std::span(entries));
  for (std::size_t tile = 0; tile < counts.size(); ++tile) {
    for (std::uint32_t k = 0; k < counts[tile]; ++k) {
      ASSERT_EQ(entries[offsets[tile] + k], 7u + k) << k << " of " << counts[tile];
    }
  }
}

class GlLongLists : public GlFrames {};

TEST_F(GlLongLists, MatchTheCpuAndRepeat) {
  const Scene scene = crowded_scene(static_cast<int>(max_shared) + 700);
  for (const AirlightMethod method : {AirlightMethod::sliced, AirlightMethod::paper}) {
    Settings settings = quick_slices();
    settings.airlight = method;
    settings.optical_depth_table = {12, 8};
    const Frame first = render_on_device(scene, settings, "crowded");
    const Frame cpu = render_frame(scene, settings);
    // The bound is that of other frames: light tables of 16 bits, and sums of thousands in single
    // precision.
    EXPECT_LT(rel_rmse(first.beauty, cpu.beauty), 1e-3);
    EXPECT_LT(rel_rmse(first.transmittance, cpu.transmittance), 1e-4);
    for (int i = 0; i < 2; ++i) {
      // Leftovers of another frame in the lists do not matter.
      render(crowded_scene(100 * (i + 1)), settings);
      const Frame again = render(scene, settings);
      EXPECT_EQ(again.beauty, first.beauty);
      EXPECT_EQ(again.airlight, first.airlight);
      EXPECT_EQ(again.transmittance, first.transmittance);
    }
  }
}

}  // namespace
}  // namespace brume::gl
