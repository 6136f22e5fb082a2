#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/io/frame_pattern.h"

namespace brume {

// The file names of a sequence. Throws UsageError.
FramePattern parse_pattern(const std::string& text);

// Adds --fps, which stands in for the frame_rate() of the scene.
void add_frame_rate(CLI::App& app, std::optional<double>& rate);

// "11-40" as 11, 12, ..., 40; "7" as 7; "1-9x2" as 1, 3, 5, 7, 9; several with commas between them.
// Each once, in the order given. Throws UsageError.
std::vector<int> parse_frames(const std::string& text);

}  // namespace brume
