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

class ViewReference;

// How wrong a frame's airlight is, measured on a sample of its own pixels.
struct ErrorEstimate {
  double rel_rmse = 0.0;  // rms(L - Lref) / rms(Lref) over RGB of the airlight
  double low = 0.0;       // interval that holds the whole frame's in 95% of cases
  double high = 0.0;
  std::size_t pixels = 0;  // of the sample
};

// Pixels of one view with the converged airlight of each: what frames of that view are held
// against. sample_chances() says where to look; where pixels that are always met turn out to be
// wrong, those around them are always met too. A few hundred are enough.
class ErrorSample {
 public:
  // Evaluates the reference at about `count` pixels of the guide's film, in parallel: milliseconds
  // a pixel. nullopt if `stop` was requested. The same for the same seed. `progress` as of
  // FrameRenderer.
  static std::optional<ErrorSample> take(const Scene& scene, const Camera& camera,
                                         const Frame& guide, std::size_t count, std::uint64_t seed,
                                         double tolerance, std::stop_token stop = {},
                                         const std::function<void(double)>& progress = {});
  // The same, with what is known already of the guide's view.
  static std::optional<ErrorSample> take(std::shared_ptr<ViewReference> reference,
                                         const Scene& scene, const Camera& camera,
                                         const Frame& guide, std::size_t count, std::uint64_t seed,
                                         std::stop_token stop = {},
                                         const std::function<void(double)>& progress = {});

  // Makes every pixel twice as likely to be met; those that were stay. False if `stop` was
  // requested: nothing has changed then.
  bool grow(const std::stop_token& stop, const std::function<void(double)>& progress = {});

  // The error of a frame of the same view and film as the guide.
  [[nodiscard]] ErrorEstimate measure(const Frame& frame) const;

 private:
  ErrorSample(std::shared_ptr<ViewReference> reference, std::vector<double> chances,
              std::uint64_t seed);
  bool look_around_errors(const Frame& guide, std::size_t most, const std::stop_token& stop);
  bool draw(const std::stop_token& stop, const std::function<void(double)>& progress);

  std::shared_ptr<ViewReference> reference_;
  std::vector<double> chances_;  // of each pixel of being met
  std::uint64_t seed_;
  std::vector<std::size_t> pixels_;  // met
};

}  // namespace brume
