#pragma once

#include <string>

#include "render/quality/error_estimate.h"
#include "tools/bench/measure/measurement.h"

namespace brume {

// Pieces of text that reports are made of.

// printf() into a text, and to the end of one.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);
[[gnu::format(printf, 2, 3)]] void put(std::string& text, const char* format, ...);

// A text as HTML and SVG have it.
std::string escaped(const std::string& text);

// "1.52 (1.40 to 1.91)", with `digits` decimals.
std::string with_spread(const Spread& spread, int digits);

// "0.53% (0.39 to 0.72)": an error and its interval.
std::string with_interval(const ErrorEstimate& error);

// "prepare 1.0 airlight 11.8": milliseconds, without stages that take next to none.
std::string stage_times(const Measurement& measurement);

}  // namespace brume
