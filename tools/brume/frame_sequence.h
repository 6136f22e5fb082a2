#pragma once

#include <string>

#include "tools/brume/command.h"
#include "tools/brume/render_options.h"

namespace brume {

// Renders the frames of an animation to one file each. Writes one while it renders the next. What
// fails in one frame is said at once and leaves the others alone; check_failed then. A line of JSON
// on standard output says which frames were made, left as they were, and failed.
ExitCode render_sequence(const RenderOptions& options);

}  // namespace brume
