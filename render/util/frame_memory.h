#pragma once

namespace brume {

// Keeps the memory of freed frames in the process. Page faults of fresh memory take a quarter of a
// frame's time. Call once at the start of programs that render many frames; no effect where the C
// library has no such setting.
void keep_frame_memory();

}  // namespace brume
