// That a cache is displaced when `brume bench` measures frames without it, and nothing else.

#include "tools/bench/measure/cache_gains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "render/renderer.h"
#include "tools/bench/measure/plan_decisions.h"
#include "tools/bench/scenes/benchmark_meshes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

// Everything that is cached: a glossy ball with radiance transfer in a cloud, under a sky and a
// light.
MovingView view_of_all() {
  MovingView view;
  view.name = "ball";
  Scene& scene = view.scene;
  scene = cloud(30, 1.0);
  scene.film = {32, 24};
  MeshBuilder ball;
  ball.ellipsoid({0.3, -0.4, 0.2}, glm::dvec3(0.5), 8);
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh = ball.finish();
  surface.transfer = Surface::Transfer::shadow;
  surface.material.type = Material::Type::phong;
  surface.material.specular = glm::dvec3(0.3);
  surface.material.exponent = 20.0;
  scene.environment.emplace().map = gradient_sky();
  const auto transfers = std::make_shared<TransferStore>();
  transfers->make(needed_transfers(scene), {});
  view.transfers = transfers;
  view.settings = sliced_settings({}, 8);
  return view;
}

// Enough Gaussians to be merged.
MovingView bank_view(bool in_motion) {
  MovingView view{"bank", fog_bank(30'000), nullptr, sliced_settings({}, 8)};
  view.scene.film = {32, 24};
  view.motion.has_own_medium = in_motion;
  return view;
}

TEST(CacheGains, HaveARowPerCache) {
  std::vector<CacheGain> gains;
  for (const MovingView& view : {view_of_all(), bank_view(false), bank_view(true)}) {
    for (CacheGain& gain : measure_caches(view, 1)) gains.push_back(std::move(gain));
  }
  std::set<std::string> names;
  for (const CacheGain& gain : gains) {
    names.insert(gain.cache);
    EXPECT_GT(gain.with_ms.median, 0.0) << gain.cache;
    EXPECT_GT(gain.with_cpu_ms.median, 0.0) << gain.cache;
    EXPECT_TRUE(std::isfinite(gain.gain.median)) << gain.cache;
    EXPECT_GT(gain.code.lines, 0) << gain.cache;
    if (gain.cache == "merged medium, where edits are followed") continue;
    EXPECT_EQ(gain.change, 0.0) << gain.cache;
  }
  EXPECT_EQ(names.size(), frame_caches().size());
}

TEST(CacheGains, LeaveOutCachesThatAreNotUsed) {
  MovingView view = view_of_all();
  view.scene.surfaces.clear();
  view.scene.environment.reset();
  for (const CacheGain& gain : measure_caches(view, 1)) {
    EXPECT_TRUE(gain.cache.find("medium") != std::string::npos ||
                gain.cache.find("optical depth") != std::string::npos)
        << gain.cache;
  }
}

// Optical depth tables are made again where they or what they are made from is displaced, and only
// there.
TEST(CacheGains, DisplaceTheirOwnCache) {
  const MovingView view = view_of_all();
  Renderer renderer(view.transfers);
  for (const FrameCache& cache : frame_caches()) {
    if (cache.method != AirlightMethod::sliced) continue;  // the others have none
    const Settings& settings = view.settings;
    const Scene& scene = view.scene;
    const auto pairs = [&] {
      return renderer.render(scene, scene.camera, scene.film, settings)->statistics.light_pairs;
    };
    static_cast<void>(pairs());
    EXPECT_EQ(pairs(), 0u) << cache.name;
    Scene other_scene = scene;
    Settings other_settings = settings;
    cache.displace(other_scene, other_settings);
    static_cast<void>(renderer.render(other_scene, scene.camera, scene.film, other_settings));
    const bool concerns_tables =
        cache.name == "index of the medium" || cache.stage == Stage::light_table;
    EXPECT_EQ(pairs() > 0, concerns_tables) << cache.name;
  }
}

}  // namespace
}  // namespace brume
