// Lists of tiles that are longer than the memory that a work group shares.

#include "render/gl/tile_lists.h"

#include <algorithm>

#include "tests/random.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/gl/gl_test.h"

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
  PointLight light;
  light.position = {3.0, 2.0, 1.0};
  light.intensity = glm::dvec3(30.0, 20.0, 10.0);
  scene.lights.push_back(light);
  return scene;
}

class TileListsTest : public GlTest {};

TEST_F(TileListsTest, AscendAtAnyLength) {
  Programs programs;
  MediumBuffers medium;
  TileLists lists;
  std::uint64_t revision = 0;
  for (const int count : {1, 2047, 2048, 2049, 3000, 5000}) {
    const Scene scene = crowded_scene(count);
    const MediumIndex index(scene.medium, 1e-6);
    const CameraRays rays(scene.camera, scene.film);
    medium.update(index, ++revision);
    lists.build(programs, medium, index, rays, scene.film, 1, 1 << 28);
    const auto tiles = static_cast<std::size_t>(lists.tiles().x * lists.tiles().y);
    std::vector<std::uint32_t> offsets(tiles + 1);
    lists.offsets().download(std::span(offsets));
    std::vector<std::uint32_t> entries(offsets.back());
    lists.entries().download(std::span(entries));
    ASSERT_EQ(entries.size(), tiles * static_cast<std::size_t>(count));
    for (std::size_t tile = 0; tile < tiles; ++tile) {
      for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(count); ++k) {
        ASSERT_EQ(entries[offsets[tile] + k], k) << "tile " << tile << " of " << count;
      }
    }
  }
}

class GlLongLists : public GlFrames {};

TEST_F(GlLongLists, MatchTheCpuAndRepeat) {
  const Scene scene = crowded_scene(static_cast<int>(max_shared) + 700);
  for (const AirlightMethod method :
       {AirlightMethod::sliced, AirlightMethod::paper}) {
    Settings settings = quick_slices();
    settings.airlight = method;
    settings.optical_depth_table = {12, 8};
    const Frame first = render_on_device(scene, settings, "crowded");
    const Frame cpu = on_cpu(scene, settings);
    // As other frames: tables of the lights of 16 bits, and sums of thousands in single precision.
    EXPECT_LT(rel_rmse(first.beauty, cpu.beauty), 1e-3);
    EXPECT_LT(rel_rmse(first.transmittance, cpu.transmittance), 1e-4);
    for (int i = 0; i < 2; ++i) {
      // What another frame leaves in the lists does not matter.
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
