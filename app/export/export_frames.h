#pragma once

#include <functional>
#include <set>
#include <string>

#include "core/io/frame_loop.h"
#include "render/util/job.h"

namespace brume {

struct Cancelled {};

// Exports the frames from first to last but those that are complete, the k-th of `count`. What
// fails in one leaves the others alone, unless it is the first: then all would fail. `failed` is
// told at once. Throws Cancelled, and at the end a runtime_error that says which frames failed and
// why.
using ExportFrame = std::function<FrameLoop::Write(int frame, int k, int count)>;
using FrameFailed = std::function<void(int frame, const std::string& why)>;
void export_frames(int first, int last, const Job& job, const ExportFrame& make,
                   const std::set<int>& complete = {}, const FrameFailed& failed = {});

}  // namespace brume
