#pragma once

namespace brume {

// Lets this process keep the memory of frames that are gone for those that follow. Getting it from
// the system anew, page by page, takes a quarter of a frame's time. For programs that render one
// frame after another, at their start; does nothing where the C library has no such setting.
void keep_frame_memory();

}  // namespace brume
