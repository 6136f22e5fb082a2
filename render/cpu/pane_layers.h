#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/frame.h"
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

}  // namespace brume
