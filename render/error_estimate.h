#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"
#include "render/frame.h"

namespace brume {

// How wrong a frame's airlight is, measured on a sample of its own pixels.
struct ErrorEstimate {
  double rel_rmse = 0.0;  // rms(L - Lref) / rms(Lref) over RGB of the airlight
  double low = 0.0;       // interval that holds the whole frame's in 95% of cases
  double high = 0.0;
  std::size_t pixels = 0;  // of the sample
};

// Pixels of one view with the converged airlight of each: what frames of that view are held
// against. Pixels are drawn half evenly and half in proportion to the radiance squared of a guide
// frame, since that is how they count in the error; so a few hundred are enough.
class ErrorSample {
 public:
  // Evaluates the reference at `count` pixels of the guide's film, in parallel: milliseconds a
  // pixel. nullopt if `stop` was requested. The same for the same seed. `progress` as of
  // FrameRenderer.
  static std::optional<ErrorSample> take(const Scene& scene, const Camera& camera,
                                         const Frame& guide, std::size_t count, std::uint64_t seed,
                                         double tolerance, std::stop_token stop = {},
                                         const std::function<void(double)>& progress = {});

  // The error of a frame of the same view and film as the guide.
  [[nodiscard]] ErrorEstimate measure(const Frame& frame) const;

 private:
  struct Pixel {
    std::size_t index;
    double weight;  // 1 / (probability of the pixel * count)
    glm::dvec3 airlight;
  };
  std::vector<Pixel> pixels_;
};

}  // namespace brume
