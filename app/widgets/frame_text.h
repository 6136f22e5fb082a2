#pragma once

#include <QString>
#include <cstdint>

namespace brume {

struct ErrorEstimate;
struct FrameError;
struct Frame;
struct FrameStatistics;
struct Settings;

// "12,408"
QString count_text(std::uint64_t count);

// "16 slices", "paper's method"
QString settings_text(const Settings& settings);

// Render device: "CPU", "OpenGL on NVIDIA H100".
QString backend_text(const FrameStatistics& statistics);

// Why OpenGL did not render a frame as requested; empty: it did, or was not requested.
QString fallback_text(const FrameStatistics& statistics);

// "64 paths, noise 1.2 %" for a path-traced frame, "64 paths, denoised" where what is left of the
// noise is not known, and "1 path". Empty for other frames.
QString paths_text(const Frame& frame);

// The orders of scattering in a frame, and how exact they are: "once", "all orders, converged to
// 0.06 % in 10 sweeps", "all orders, 64 paths, noise 1.2 %".
QString scattering_text(const Frame& frame);

// A bound as it was chosen: "2 %".
QString bound_text(double share);

// The relative error and how far off it may be: "1.4 ± 0.2 %".
QString error_text(const ErrorEstimate& error);

// That of the airlight, and of the whole picture where it differs: "1.4 ± 0.2 %, picture 2.0 ± 0.4
// %".
QString errors_text(const FrameError& error);

// The median of blocks: "2.1 %, 1.8 to 2.6 %"
QString block_error_text(const ErrorEstimate& error);

// "1.2 to 1.6 %"
QString interval_text(const ErrorEstimate& error);

}  // namespace brume
