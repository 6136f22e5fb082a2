#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/settings.h"

namespace brume {

// Renders frames of scenes, on whatever it runs. Keeps between frames what has not changed. Not
// thread-safe: one frame at a time.
class FrameRenderer {
 public:
  virtual ~FrameRenderer() = default;

  // The frame that `camera` sees on `film` (the scene's own are not used). Every value of the
  // frame is finite except the depth where nothing is hit. nullopt if `stop` was requested.
  // `progress` hears the share that is done, in [0, 1], from the rendering threads, one at a time.
  virtual std::optional<Frame> render(const Scene& scene, const Camera& camera, const Film& film,
                                      const Settings& settings, std::stop_token stop = {},
                                      const std::function<void(double)>& progress = {}) = 0;
};

}  // namespace brume
