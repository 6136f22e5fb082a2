#pragma once

#include <span>

#include "core/io/frame_loop.h"
#include "tools/brume/command.h"

namespace brume {

// Runs frames of a subcommand. What fails in one is said at once, and leaves the others alone;
// check_failed then.
ExitCode run_frames(std::span<const int> frames, const FrameLoop::Make& make);

}  // namespace brume
