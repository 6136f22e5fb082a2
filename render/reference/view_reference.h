#pragma once

#include <functional>
#include <unordered_map>

#include "render/reference/reference_pixels.h"

namespace brume {

// Caches the converged airlight of one view's pixels. Not thread-safe.
class ViewReference {
 public:
  // See ReferencePixels.
  ViewReference(const Scene& scene, const Camera& camera, const Film& film, double tolerance)
      : reference_(scene, camera, film, tolerance) {}

  // Evaluates pixels that are not cached, in parallel, milliseconds each. False if `stop` was
  // requested. `progress`: see FrameRenderer.
  bool evaluate(std::span<const std::size_t> pixels, const std::stop_token& stop,
                const std::function<void(double)>& progress = {});

  // Airlight of an evaluated pixel.
  [[nodiscard]] const glm::dvec3& airlight(std::size_t pixel) const { return known_.at(pixel); }

  // Number of evaluated pixels.
  [[nodiscard]] std::size_t size() const { return known_.size(); }

 private:
  ReferencePixels reference_;
  std::unordered_map<std::size_t, glm::dvec3> known_;
};

}  // namespace brume
