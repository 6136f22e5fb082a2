#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brume/scene.h"
#include "core/math/spread.h"
#include "render/frame_renderer.h"
#include "render/quality/error_estimate.h"
#include "render/renderer.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {

// The cost of frames when the camera moves a little from each to the next.
struct MovedFrames {
  Spread milliseconds;
  Spread cpu_milliseconds;        // summed over threads: less sensitive to other programs
  std::vector<StageTime> stages;  // medians
};

// Time since it was made [ms]: of the clock, and of the CPU, all threads together.
class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const;
  [[nodiscard]] double cpu_milliseconds() const;

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double cpu_begin_ = cpu_seconds();
};

// How the camera moves from frame to frame.
struct CameraStep {
  // Around its target [degrees]. 0: towards it, so little that no cost changes.
  double turn = 0.0;
  int first = 1;  // steps that the first frame has taken
};
// The camera after so many steps.
Camera moved(Camera camera, const CameraStep& step, int steps);

// Renders a number of frames, or more for at most `seconds`, up to 15. Uses the caches of
// `renderer`, which a first frame must have filled.
MovedFrames moved_frames(FrameRenderer& renderer, const Scene& scene, const Settings& settings,
                         int min_frames, double seconds = 0.0, const CameraStep& step = {});

// The time of the second of two frames over that of the first: render(k, i) is the time of the
// k-th in the i-th round, in turn, so that other programs disturb both alike. The first round,
// which fills caches, does not count.
Spread frame_time_ratio(int rounds, const std::function<double(std::size_t k, int i)>& render);
// The same of a moving camera with two settings.
Spread frame_time_ratio(std::array<Renderer, 2> renderers, const Scene& scene,
                        const std::array<Settings, 2>& settings, int frames,
                        const CameraStep& step = {});

// Cost and error of one setting on one view, from the same frames.
struct Measurement : MovedFrames {
  std::string setting;  // "sliced 24, scale 4"
  Settings settings;
  double first_milliseconds = 0.0;
  double first_cpu_milliseconds = 0.0;
  ErrorEstimate error;
  std::uint64_t pairs = 0;  // Gaussian x ray pairs of the view
};

std::string setting_name(const Settings& settings);

// Pixels of the view with their converged airlight, and the cost of a full frame of them.
struct ReferenceSample {
  ErrorSample sample;
  double frame_cpu_milliseconds;
};
ReferenceSample find_reference(const Scene& scene, std::size_t pixels, double tolerance = 1e-4);

// A first frame, of which the error is, and moved ones: 3 to 15 in `seconds`.
Measurement measure(FrameRenderer& renderer, const Scene& scene, const Settings& settings,
                    const ErrorSample& reference, double seconds, const CameraStep& step = {});

// The settings that no other one beats in both CPU time and error, from cheap to costly: indices.
std::vector<std::size_t> frontier(std::span<const Measurement> settings);

// The cheapest setting (CPU time) whose error, by the upper end of its interval, is at most
// `error`: an index.
std::optional<std::size_t> cheapest_within(std::span<const Measurement> settings, double error);

// One point of a cost curve.
struct CostPoint {
  double size = 0.0;              // Gaussians, lights, pixels, slices
  double cpu_milliseconds = 0.0;  // > 0
};

// Exponent p of cost ~ size^p by least squares of logarithms; at least two sizes.
double fitted_exponent(std::span<const CostPoint> points);

// A bank of many small Gaussians that fills the view of 800 x 600, with the fewest slices for 2%.
struct FogBankRow {
  int gaussians = 0;
  std::size_t merged = 0;  // into as many; 0: not
  Measurement measurement{};
  Spread unmerged_ratio{};  // frame times without merging over those with
};

std::vector<FogBankRow> measure_fog_banks(bool quick);

}  // namespace brume
