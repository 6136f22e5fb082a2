#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brume/camera.h"
#include "brume/export.h"
#include "brume/image_layers.h"
#include "brume/stage.h"

namespace brume {

struct RenderRequest;

struct StageTime {
  Stage stage = Stage::frame;
  double milliseconds = 0.0;
};

// Adds to the time of the stage; a new one is appended.
BRUME_EXPORT void add_time(std::vector<StageTime>& stages, Stage stage, double milliseconds);

struct SkippedStage {
  Stage stage = Stage::frame;
  std::string why;  // the words of a Reason, or of an error
};

// How far the iteration for light scattered more than once came.
struct Convergence {
  int sweeps = 0;
  // Change in the last sweep relative to the light at each node, or to a hundredth of the most: rms
  // over what scatters it.
  double residual = 0.0;
};

// How noisy a path-traced frame is: sums over pixels and channels of squared standard errors.
struct PathNoise {
  int paths = 0;  // per pixel, >= 2
  double airlight_variance = 0.0;
  double surface_variance = 0.0;  // of surfaces seen through the medium
};

// Costs of a frame, and the stages it skipped.
struct FrameStatistics {
  std::string backend = "cpu";  // or gl
  std::string airlight;         // the method with its parameter, "sliced:24"
  std::string device;           // name of the OpenGL device; empty: the CPU
  double frame_milliseconds = 0.0;
  double transfer_milliseconds = 0.0;  // before it, for radiance transfer that was missing
  double extra_milliseconds = 0.0;     // after it, for more layers and to measure its error
  std::vector<StageTime> stages;       // in the order they first ran
  std::vector<SkippedStage> skipped;   // not needed by the scene, with the reason
  // With the backend gl: stages that ran on the CPU, with the reason.
  std::vector<SkippedStage> on_cpu;
  std::size_t gaussians_total = 0;
  std::size_t gaussians_used = 0;
  std::size_t gaussians_merged = 0;  // what all were merged into; 0: they were not
  std::size_t exact_pixels = 0;      // airlight evaluated, not interpolated
  std::size_t sampled_pixels = 0;    // by more than their centers
  std::uint64_t light_pairs = 0;     // Gaussian x ray pairs evaluated from lights
  std::uint64_t view_pairs = 0;      // Gaussian x ray pairs evaluated from the eye
  std::optional<Convergence> scattering;
  std::size_t grid_bytes = 0;  // memory of the light that a grid holds
  // view_pairs per pixel, 0 for interpolated ones; empty without a medium.
  std::vector<float> pixel_pairs;
  std::optional<PathNoise> path_noise;  // of `path` with two paths or more
};

// The side of the blocks of a picture that are judged each by itself [pixels].
inline constexpr int error_block = 8;

// Error of the airlight or of the whole picture, estimated from a sample of a frame's pixels.
struct ErrorEstimate {
  double rel_rmse = 0.0;  // rms(L - Lref) / rms(Lref) over RGB
  double low = 0.0;       // 95% confidence interval
  double high = 0.0;
  std::size_t pixels = 0;  // of the sample
  double noise = 0.0;  // share of the interval's variance that is noise of the reference's paths
  // The same of blocks of the frame, each relative to its own light: the median over those that
  // have any. A pixel of the sample stands for its block. 0 of a black frame.
  double block_median = 0.0;
  double block_low = 0.0;  // 95% confidence interval
  double block_high = 0.0;
};

// A rendered frame: linear radiance, rows from the top, width * height pixels. Its `depth` is a
// distance; elsewhere `depth` is optical depth.
struct Frame {
  Film film;
  Camera camera;                     // that saw it
  double time = 0.0;                 // Scene::time [s]
  double frames_per_second = 0.0;    // frame_rate() of the scene; 0: not known
  std::vector<float> beauty;         // RGBA per pixel; A = 1 on surfaces, else 1 - transmittance
  std::vector<float> airlight;       // RGB per pixel
  std::vector<float> transmittance;  // RGB per pixel, eye to first surface or through the medium
  // Distance along the view ray through the center [u], +inf where nothing is hit; never filtered.
  std::vector<float> depth;
  // The airlight, RGB, and the beauty, RGBA, of rays through centers, where those of pixels are
  // filtered; else empty. What errors are measured by.
  std::vector<float> airlight_at_centers, beauty_at_centers;
  // The environment behind all, as much as a pixel shows of it and the medium lets through, RGB
  // per pixel; it is in beauty, too. Empty: it was not asked for (layers do).
  std::vector<float> background;
  FrameStatistics statistics;
  // A frame that a RenderRequest asked for has the request, with all that was chosen, so
  // that it makes the frame again; its errors, if they are known, layers besides those above, and
  // what there is to say of it, a line each.
  std::shared_ptr<const RenderRequest> request;
  std::optional<ErrorEstimate> error;  // of the airlight, for the orders that were rendered
  // The same of the beauty, for all the light that there is: surfaces, what they mirror and let
  // through, what shines, and the environment.
  std::optional<ErrorEstimate> picture_error;
  ImageLayers layers;
  std::vector<std::string> warnings;

  [[nodiscard]] const std::vector<float>& center_airlight() const {
    return airlight_at_centers.empty() ? airlight : airlight_at_centers;
  }
  [[nodiscard]] const std::vector<float>& center_beauty() const {
    return beauty_at_centers.empty() ? beauty : beauty_at_centers;
  }
};

// Frames hold finite values: radiance beyond the range of float is clamped; NaN would be a bug of
// ours and becomes black.
constexpr float max_radiance = 1e30f;
inline float finite(float x) {
  assert(!std::isnan(x));
  return std::isnan(x) ? 0.0f : std::clamp(x, 0.0f, max_radiance);
}

// Standard error of a path-traced frame, relative to the RMS of the layer; 0 where that is black.
struct RelativeNoise {
  int paths = 0;
  double airlight = 0.0;
  double picture = 0.0;
};
BRUME_EXPORT std::optional<RelativeNoise> relative_noise(const Frame& frame);

// 2^stops; 1 for NaN.
BRUME_EXPORT float exposure_gain(double stops);

}  // namespace brume
