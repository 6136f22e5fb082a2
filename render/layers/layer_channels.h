#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <string>

#include "core/io/image/image_file.h"

namespace brume {

// Three channels of an image.
class LayerChannels {
 public:
  // Adds "NAME.R", "NAME.G" and "NAME.B", or with other letters, all 0.
  LayerChannels(ImageLayers& image, const std::string& name, const char* letters = "RGB") {
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<float>& values = image.channels[name + "." + letters[c]];
      values.assign(pixels, 0.0f);
      channels_[c] = values.data();
    }
  }
  void set(std::size_t pixel, const glm::vec3& value) const {
    for (std::size_t c = 0; c < 3; ++c) channels_[c][pixel] = value[static_cast<int>(c)];
  }

 private:
  std::array<float*, 3> channels_;
};

}  // namespace brume
