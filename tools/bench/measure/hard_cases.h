#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brume/frame.h"
#include "brume/scene.h"
#include "render/frame_renderer.h"

namespace brume {

// Scenes that break careless arithmetic, with what their pixels are, computed elsewhere to eleven
// digits (tools/make-hard-cases): resources/hard_cases.

struct HardCase {
  std::string name;
  std::string breaks, remedy;  // what a naive renderer does, and what this one does about it
  Scene scene;
  double bound = 0.0;  // most that `sliced` with 24 slices is off, see HardCaseError
  std::string why;     // it is more than 1%; empty: it is not
  // The layers of a frame.
  std::vector<float> airlight, transmittance;
};

std::vector<HardCase> load_hard_cases();

struct HardCaseError {
  // rms of the difference over the rms, RGB; where all is black 0, or infinite if light is seen.
  double airlight = 0.0;
  double transmittance = 0.0;  // maximum difference
};
// NaN where a pixel is.
HardCaseError error_of(const Frame& frame, const HardCase& hard_case);

// `sliced` with 24 slices, the bound for every backend.
HardCaseError sliced_error(FrameRenderer& renderer, const HardCase& hard_case);

// `auto` with a bound of 2%: its error, and whether it reports failure.
struct HardCaseAuto {
  double airlight = 0.0;
  bool is_told = false;
};
inline constexpr double hard_case_max_error = 0.02;

// The errors of one case, each way of rendering it.
struct HardCaseErrors {
  HardCaseError reference;          // in double
  HardCaseError sliced;             // 24 slices, SIMD in float
  std::optional<HardCaseError> gl;  // the same on another renderer
  HardCaseAuto automatic;
  // `paper` in SIMD float against scalar double; tests arithmetic, not the approximation.
  double paper = 0.0;
};
HardCaseErrors measure_hard_case(const HardCase& hard_case, FrameRenderer* gl = nullptr);

// Bounds for every case, in addition to its own bound for `sliced`.
inline constexpr double hard_case_reference_bound = 1e-3;      // ten times its default tolerance
inline constexpr double hard_case_transmittance_bound = 2e-3;  // twice Settings::depth_error
inline constexpr double hard_case_paper_bound = 1e-3;

}  // namespace brume
