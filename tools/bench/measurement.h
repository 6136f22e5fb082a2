#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "render/error_estimate.h"
#include "render/frame_renderer.h"

namespace brume {

// Median and spread of something measured several times.
struct Spread {
  double median = 0.0;
  double least = 0.0;
  double greatest = 0.0;
};
// Of at least one value.
Spread spread_of(std::vector<double> values);

// What one setting costs on one view, and how wrong it is: of the same frames.
struct Measurement {
  std::string setting;  // "sliced 24, scale 4"
  Settings settings;
  Spread milliseconds;      // of a frame with the camera moved a little
  Spread cpu_milliseconds;  // the same, all threads together: other programs matter less to it
  double first_milliseconds = 0.0;
  ErrorEstimate error;
  std::vector<StageTime> stages;  // medians
  std::uint64_t pairs = 0;        // Gaussian x ray pairs of the view
};

std::string setting_name(const Settings& settings);

// Pixels of the view with their converged airlight, and what a whole frame of those would cost.
struct Truth {
  ErrorSample sample;
  double frame_cpu_milliseconds;
};
Truth find_truth(const Scene& scene, std::size_t pixels);

// Renders moved frames for `seconds`, 3 to 15 of them. What `renderer` has kept is not made again.
Measurement measure(FrameRenderer& renderer, const Scene& scene, const Settings& settings,
                    const ErrorSample& truth, double seconds);

}  // namespace brume
