#pragma once

namespace brume::gl {

// What a display shows of a frame.
struct DisplayOptions {
  enum class Layer { beauty, airlight };
  Layer layer = Layer::beauty;
  double exposure = 0.0;  // [stops]
  bool depth = false;     // wanted in memory as well, where there are surfaces
};

}  // namespace brume::gl
