#pragma once

#include <tbb/task_arena.h>

#include "render/gl/film_airlight.h"
#include "render/gl/resources.h"
#include "render/prepare/frame_stages.h"

namespace brume::gl {

// The distances to surfaces, of a frame that otherwise stays on the device.
void read_depth(const FilmTextures& textures, Frame& frame);

// Fetches the layers of frames from the device.
class ReadBack {
 public:
  // Has the device copy them once it has made them, and does not wait.
  void start(const FilmTextures& textures);
  // Waits, and fills the layers of the frame, which has room for them, in the arena's threads.
  void finish(FrameContext& work, tbb::task_arena& arena);

 private:
  HostBuffer copies_;
};

}  // namespace brume::gl
