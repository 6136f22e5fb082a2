#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/frame.h"
#include "core/scene/camera_rays.h"
#include "render/cpu/tile_sampler.h"
#include "render/prepare/frame_stages.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Composites path-traced frames of the first, second, ... surfaces on the view rays: with airlight
// A_k as far as the k-th, whose radiance S_k the medium attenuates by T_k, which covers c_k of what
// is behind and lets P_k of its light through, the picture is
//   sum_k (P_1 ... P_k-1) (A_k - A_k-1 + c_k T_k S_k)
class PaneLayers {
 public:
  explicit PaneLayers(const Frame& frame);

  // Adds the next layer; `panes`: that it sees, by pixel.
  void add(std::span<const SeenPane> panes, const Frame& layer);
  // Whether light of farther layers comes through.
  [[nodiscard]] bool are_open() const { return is_open_; }
  // The share of the next layer's light that comes through.
  [[nodiscard]] float passing(std::size_t pixel) const { return pixels_[pixel].passing; }
  // Sets the frame to the sums, its background if it has one; its depth is that of the first
  // surface that is more than half opaque.
  void write(Frame& frame) const;

 private:
  struct Pixel {
    float passing = 1.0f;  // of light from the next layer
    float depth;
    float transmittance = 1.0f;
    float alpha = 0.0f;
    bool has_depth = false;
    glm::vec3 airlight_before{0.0f};  // as far as the last layer
    glm::vec3 airlight{0.0f}, beauty{0.0f};
    glm::vec3 background{0.0f};  // the part of beauty that open rays show behind the medium
  };
  std::vector<Pixel> pixels_;
  bool is_open_ = true;
};

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
