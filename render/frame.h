#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/image_file.h"
#include "core/scene/camera.h"

namespace brume {

struct StageTime {
  std::string name;
  double milliseconds = 0.0;
};

struct SkippedStage {
  std::string stage;
  std::string why;
};

// What a frame cost and what it left out.
struct FrameStatistics {
  std::string backend = "cpu";  // or gl
  std::string device;           // of gl; empty: the processor
  double frame_milliseconds = 0.0;
  std::vector<StageTime> stages;      // in the order they ran
  std::vector<SkippedStage> skipped;  // what this scene did not need, and why
  // Where gl was asked for: what the CPU did all the same, and why.
  std::vector<SkippedStage> on_cpu;
  std::size_t gaussians_total = 0;
  std::size_t gaussians_used = 0;
  std::size_t exact_pixels = 0;   // whose airlight is not interpolated
  std::uint64_t light_pairs = 0;  // Gaussian x ray pairs evaluated from lights
  std::uint64_t view_pairs = 0;   // Gaussian x ray pairs evaluated from the eye
  // Of view_pairs those for each pixel; 0 where airlight is interpolated. Empty without a medium.
  std::vector<float> pixel_pairs;
};

// A rendered frame: linear radiance, rows from the top, width * height pixels.
struct Frame {
  Film film;
  double time = 0.0;                 // that it shows, see Settings [s]
  std::vector<float> beauty;         // RGBA per pixel; A = 1 on surfaces, else 1 - transmittance
  std::vector<float> airlight;       // RGB per pixel
  std::vector<float> transmittance;  // RGB per pixel, eye to first surface or through the medium
  std::vector<float> depth;          // distance along the view ray [u], +inf where nothing is hit
  FrameStatistics statistics;
};

// What a frame promises: radiance beyond float is as bright as can be, and a broken sum, which is a
// mistake of ours, black.
constexpr float most_radiance = 1e30f;
inline float finite(float x) {
  assert(!std::isnan(x));
  return std::isnan(x) ? 0.0f : std::clamp(x, 0.0f, most_radiance);
}

// The EXR layers of the contract: R G B A, airlight.R/G/B, transmittance.R/G/B, Z.
ImageLayers to_layers(const Frame& frame);

// What an exposure multiplies radiance with; none if it is NaN.
float exposure_gain(double stops);

// What the screen and PNG show of linear radiance: 8-bit sRGB, RGB per pixel. `exposure` is in
// stops. See view_transform.h for the curve; it is never baked into an EXR.
std::vector<std::uint8_t> to_display(const Frame& frame, double exposure);

}  // namespace brume
