#pragma once

#include <QString>
#include <cstdint>

namespace brume {

struct ErrorEstimate;
struct FrameStatistics;
struct Settings;

// "12,408"
QString count_text(std::uint64_t count);

// "sliced 16", "paper"
QString settings_text(const Settings& settings);

// Render device: "CPU", "OpenGL on NVIDIA H100".
QString backend_text(const FrameStatistics& statistics);

// Why OpenGL did not render a frame as requested; empty: it did, or was not requested.
QString fallback_text(const FrameStatistics& statistics);

// A share in per cent, to about two digits: "1.4 %".
QString percent_text(double share);

// A bound as it was chosen: "2 %".
QString bound_text(double share);

// The relative error and how far off it may be: "1.4 ± .2 %".
QString error_text(const ErrorEstimate& error);

// "1.2 to 1.6 %"
QString interval_text(const ErrorEstimate& error);

}  // namespace brume
