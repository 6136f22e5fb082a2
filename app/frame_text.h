#pragma once

#include <QString>
#include <cstdint>

namespace brume {

struct ErrorEstimate;
struct Settings;

// "12,408"
QString count_text(std::uint64_t count);

// "sliced 16", "paper"
QString settings_text(const Settings& settings);

// A share in per cent, to about two digits: "1.4 %".
QString percent_text(double share);

// A bound as it was chosen: "2 %".
QString bound_text(double share);

// The relative error and how far off it may be: "1.4 ± .2 %".
QString error_text(const ErrorEstimate& error);

// "1.2 to 1.6 %"
QString interval_text(const ErrorEstimate& error);

}  // namespace brume
