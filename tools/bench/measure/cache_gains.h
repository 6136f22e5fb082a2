#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brume/scene.h"
#include "brume/stage.h"
#include "render/render_plan.h"
#include "render/transfer/transfer_store.h"
#include "tools/bench/measure/measurement.h"

namespace brume {

// Median and quartiles of something measured several times.
struct Quartiles {
  double median = 0.0;
  double lower = 0.0;
  double upper = 0.0;
};
// At least one value.
Quartiles quartiles_of(std::vector<double> values);

// The code that a cache costs: lines that would go with it, counted by hand.
struct CacheCode {
  int lines = 0;
  const char* files = "";
};

// Something that a renderer keeps from one frame of a moving camera to the next.
struct FrameCache {
  std::string_view name;
  CacheCode code;
  AirlightMethod method = AirlightMethod::sliced;
  Stage stage = Stage::prepare;  // in which it is made
  bool (*is_used)(const RenderPlan& plan, const Scene& scene) = nullptr;
  // Changes a frame such that the renderer replaces this cache for it, but no other of the stage.
  void (*displace)(Scene& scene, Settings& settings) = nullptr;
  // The edit between two frames; null: only the camera moves.
  void (*edit)(Scene& scene) = nullptr;
};
std::span<const FrameCache> frame_caches();

// A view that moves: a scene, its radiance transfer, and the settings of `sliced`.
struct MovingView {
  std::string name;
  Scene scene;
  std::shared_ptr<const TransferStore> transfers;
  Settings settings;
  Motion motion{};

  [[nodiscard]] Settings settings_of(AirlightMethod method) const;
};

// Frames with a cache beside frames without. One without it takes as long as one with, and longer
// by what its stage takes longer: what is computed from the cache in other stages is kept.
struct CacheGain {
  std::string cache;
  std::string scene;
  CacheCode code;
  Quartiles with_ms, without_ms;  // of a frame
  Spread with_cpu_ms;
  Quartiles gain;       // of frames per second, from pairs of frames: 0.25 is a quarter more
  double change = 0.0;  // largest of a pair's pictures: max_change()
};

// All frame_caches() that the view uses, in pairs of frames, one after the other.
std::vector<CacheGain> measure_caches(const MovingView& view, int pairs);

}  // namespace brume
