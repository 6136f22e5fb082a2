#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "brume/frame.h"
#include "brume/scene.h"

namespace brume {

class ViewReference;

// A random sample of a view's pixels with what they ought to be. Importance-sampled by
// sample_probabilities(). Pixels of probability 1 with large error add their 3x3 neighbourhood at
// probability 1. A few hundred pixels suffice.
class ErrorSample {
 public:
  // Paths of a pixel to begin with, where any are needed, on average.
  static constexpr int default_paths = 64;

  // Evaluates the reference at about `count` pixels of the guide's film, in parallel (milliseconds
  // per pixel). nullopt if `stop` was requested. Deterministic for a given seed. `progress`: see
  // FrameRenderer.
  static std::optional<ErrorSample> create(const Scene& scene, const Camera& camera,
                                           const Frame& guide, std::size_t count,
                                           std::uint64_t seed, double tolerance,
                                           const std::stop_token& stop = {},
                                           const std::function<void(double)>& progress = {});
  // Like above, reusing pixels of the view that are already evaluated.
  static std::optional<ErrorSample> create(std::shared_ptr<ViewReference> reference,
                                           const Scene& scene, const Camera& camera,
                                           const Frame& guide, std::size_t count,
                                           std::uint64_t seed, const std::stop_token& stop = {},
                                           const std::function<void(double)>& progress = {},
                                           int paths = default_paths);

  // Multiplies the sampling probability of every pixel, keeping those sampled. False, and
  // unchanged, if `stop` was requested.
  bool grow(const std::stop_token& stop, const std::function<void(double)>& progress = {},
            double factor = 2.0);

  // Multiplies the paths of the sample's pixels, up to a limit. False, and unchanged, if there are
  // as many, the reference has none, or `stop` was requested.
  bool refine(const std::stop_token& stop, const std::function<void(double)>& progress = {},
              double factor = 2.0);

  // The error of the airlight of a frame of the same view and film as the guide.
  [[nodiscard]] ErrorEstimate measure(const Frame& frame) const;
  // That of its picture, where the reference has one.
  [[nodiscard]] ErrorEstimate measure_picture(const Frame& frame) const;

 private:
  ErrorSample(std::shared_ptr<ViewReference> reference, std::vector<double> probabilities,
              const Frame& guide, std::uint64_t seed, int paths);
  [[nodiscard]] ErrorEstimate estimate(const Frame& frame, bool is_picture) const;
  bool sample_around_errors(const Frame& guide, std::size_t max_pixels,
                            const std::stop_token& stop);
  bool sample_pixels(const std::stop_token& stop, const std::function<void(double)>& progress);
  // Evaluates pixels with their share of so many paths on average.
  bool evaluate(std::span<const std::size_t> pixels, int paths, const std::stop_token& stop,
                const std::function<void(double)>& progress = {}) const;

  std::shared_ptr<ViewReference> reference_;
  std::vector<double> probabilities_;  // sampling probability of each pixel
  std::uint64_t seed_;
  std::vector<std::size_t> pixels_;  // sampled
  int paths_;                        // of a pixel, on average
  std::vector<float> path_shares_;   // of each pixel, relative to that
};

}  // namespace brume
