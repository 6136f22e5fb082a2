#include "tools/bench/measure/frames.h"

#include <limits>
#include <span>

#include "render/output/compare.h"
#include "render/renderer.h"

namespace brume {

Frame render_frame(const Scene& scene, const Settings& settings) {
  Renderer renderer;
  return render_frame(renderer, scene, settings);
}

Frame render_frame(FrameRenderer& renderer, const Scene& scene, const Settings& settings) {
  return renderer.render(scene, scene.camera, scene.film, settings).value();
}

double rel_rmse(const std::vector<float>& a, const std::vector<float>& b) {
  const ChannelPair pair{a, b};
  const Comparison result = compare(std::span(&pair, 1));
  return result.incomparable > 0 ? std::numeric_limits<double>::infinity() : result.rel_rmse;
}

}  // namespace brume
