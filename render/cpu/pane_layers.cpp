#include "render/cpu/pane_layers.h"

#include <cmath>
#include <limits>

namespace brume {
namespace {

glm::vec3 rgb(const std::vector<float>& layer, std::size_t pixel, std::size_t channels) {
  const float* const first = layer.data() + channels * pixel;
  return {first[0], first[1], first[2]};
}

}  // namespace

PaneLayers::PaneLayers(const Frame& frame) : pixels_(frame.depth.size()) {
  for (Pixel& pixel : pixels_) pixel.depth = std::numeric_limits<float>::infinity();
}

void PaneLayers::add(std::span<const SeenPane> panes, const Frame& layer) {
  is_open_ = false;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    Pixel& pixel = pixels_[i];
    if (!(pixel.passing > 0.0f)) continue;
    const SeenPane& pane = panes[i];
    const float transmittance = rgb(layer.transmittance, i, 3).x;  // grey within a group
    const glm::vec3 airlight = rgb(layer.airlight, i, 3);
    const glm::vec3 attenuated = rgb(layer.beauty, i, 4) - airlight;
    const glm::vec3 scattered = pixel.passing * (airlight - pixel.airlight_before);
    pixel.airlight += scattered;
    pixel.beauty += scattered + pixel.passing * static_cast<float>(pane.covered) * attenuated;
    pixel.airlight_before = airlight;
    const bool is_surface = std::isfinite(layer.depth[i]);
    if (!pixel.has_depth) pixel.transmittance = transmittance;
    if (is_surface && pane.opaque > 0.5 && !pixel.has_depth) {
      pixel.depth = layer.depth[i];
      pixel.has_depth = true;
    }
    if (is_surface) {
      pixel.passing *= static_cast<float>(pane.passing);
      if (pixel.passing > 0.0f) is_open_ = true;
      pixel.alpha = 1.0f;
      continue;
    }
    pixel.background = pixel.passing * attenuated;
    // Alpha of what is open: render_groups() takes it from the transmittance.
    if (!pixel.has_depth) pixel.transmittance = pixel.passing * transmittance;
    pixel.alpha = 1.0f - pixel.passing * transmittance;
    pixel.passing = 0.0f;
  }
}

void PaneLayers::write(Frame& frame) const {
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Pixel& pixel = pixels_[i];
    for (std::size_t c = 0; c < 3; ++c) {
      frame.airlight[3 * i + c] = pixel.airlight[static_cast<int>(c)];
      frame.transmittance[3 * i + c] = pixel.transmittance;
      frame.beauty[4 * i + c] = pixel.beauty[static_cast<int>(c)];
      if (frame.background.empty()) continue;
      frame.background[3 * i + c] = pixel.background[static_cast<int>(c)];
    }
    frame.beauty[4 * i + 3] = pixel.alpha;
    frame.depth[i] = pixel.depth;
  }
}

}  // namespace brume
