#pragma once

#include <functional>
#include <unordered_map>

#include "render/reference/reference_pixels.h"

namespace brume {

// What is known of the converged airlight of one view: each pixel is evaluated once, whoever asks
// for it. For one thread at a time.
class ViewReference {
 public:
  // As of ReferencePixels.
  ViewReference(const Scene& scene, const Camera& camera, const Film& film, double time,
                double tolerance)
      : reference_(scene, camera, film, time, tolerance) {}

  // Makes the airlight of these pixels known, in parallel, milliseconds each. False if `stop` was
  // requested. `progress` as of FrameRenderer.
  bool evaluate(std::span<const std::size_t> pixels, const std::stop_token& stop,
                const std::function<void(double)>& progress = {});

  // Of a pixel that was evaluated.
  [[nodiscard]] const glm::dvec3& airlight(std::size_t pixel) const { return known_.at(pixel); }

  // How many were evaluated.
  [[nodiscard]] std::size_t size() const { return known_.size(); }

 private:
  ReferencePixels reference_;
  std::unordered_map<std::size_t, glm::dvec3> known_;
};

}  // namespace brume
