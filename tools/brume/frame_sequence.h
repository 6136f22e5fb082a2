#pragma once

#include <filesystem>

#include "render/deep/deep_file.h"
#include "tools/brume/command.h"
#include "tools/brume/render_options.h"

namespace brume {

// Writes the deep file of a frame, with a warning where it is not fine enough. Throws InputError,
// Interrupted.
DeepFileStatistics write_deep(SceneRenderer& renderer, const std::filesystem::path& file,
                              const Scene& scene, const Frame& frame, const FrameInfo& info);

// Renders the frames of an animation to one file each. Writes one while it renders the next. What
// fails in one frame is said at once and leaves the others alone; check_failed then. A line of JSON
// on standard output says which frames were made, left as they were, and failed.
ExitCode render_sequence(const RenderOptions& options);

}  // namespace brume
