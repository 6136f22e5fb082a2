#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/cpu/tile_sampler.h"
#include "render/prepare/frame_stages.h"

namespace brume {

// The pixels of a frame that see something through panes, and the fog in front of what they see
// first and last: with these two known, seldom is fog between panes evaluated ray by ray.
class PaneView {
 public:
  // FrameStages::find_hits() has been called. Keeps nothing.
  PaneView(const FrameStages& stages, const FrameContext& work);

  [[nodiscard]] bool empty() const { return around_.x0 >= around_.x1; }
  // A rectangle that holds them.
  [[nodiscard]] const CameraRays::PixelRectangle& around() const { return around_; }
  // PixelDetail::surfaces at these pixels, none at others.
  [[nodiscard]] std::span<const PixelDetail> pixels() const { return pixels_; }
  // The ends of the view rays at what is seen last.
  [[nodiscard]] RayEnds ends() const { return {open_, last_.distances}; }
  // The same as hits, at these pixels alone, and their copies, if anything has any.
  [[nodiscard]] std::span<const RasterPixel> hits() const { return hits_; }
  [[nodiscard]] std::span<const std::uint32_t> copies() const { return copies_; }

  // Keeps the fog of a frame of the first hits as that in front of these. integrate() then fills
  // its layers of airlight and transmittance at the pixels as far as ends(), its depth layer being
  // theirs; in the end the frame is as it was.
  void find_fog(Frame& frame, const std::function<void()>& integrate);
  // The fog that is known after that.
  [[nodiscard]] std::array<KnownFog, 2> fogs() const { return {known(first_), known(last_)}; }

 private:
  struct Layer {
    std::vector<float> airlight, transmittance, depth;
    std::vector<double> distances;  // depth in double
  };
  [[nodiscard]] KnownFog known(const Layer& layer) const {
    return {layer.airlight, layer.transmittance, layer.depth, {open_, layer.distances}};
  }

  double open_;
  CameraRays::PixelRectangle around_;
  std::vector<PixelDetail> pixels_;
  std::vector<RasterPixel> hits_;
  std::vector<std::uint32_t> copies_;
  Layer first_, last_;
};

}  // namespace brume
