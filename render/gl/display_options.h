#pragma once

namespace brume::gl {

// Which parts of a frame are displayed.
struct DisplayOptions {
  enum class Layer { beauty, airlight };
  Layer layer = Layer::beauty;
  double exposure = 0.0;  // [stops]
  bool depth = false;     // also download the depth, if there are surfaces
};

}  // namespace brume::gl
