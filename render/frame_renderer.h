#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "brume/frame.h"
#include "brume/scene.h"
#include "render/motion.h"
#include "render/settings.h"

namespace brume {

// Interface of all renderers. Caches data between frames. Not thread-safe.
class FrameRenderer {
 public:
  virtual ~FrameRenderer() = default;

  // Renders the scene as seen by `camera` on `film` (the scene's own are ignored). `auto_` is
  // rendered as `sliced`; render_requested() chooses and measures. A region has the bits of the
  // whole film where Settings::brightness is given or does not matter. All values of the frame are
  // finite except the depth where nothing is hit. nullopt if `stop` was requested. `progress` gets
  // the completed fraction in [0, 1], from the rendering threads, one call at a time. `motion`: of
  // the editor's views.
  virtual std::optional<Frame> render(const Scene& scene, const Camera& camera, const Film& film,
                                      const Settings& settings, std::stop_token stop = {},
                                      const std::function<void(double)>& progress = {},
                                      const Motion& motion = {}) = 0;
};

}  // namespace brume
