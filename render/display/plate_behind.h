#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "brume/frame.h"

namespace brume {

// A photographed picture in place of what a frame shows behind all: the fog in front of it scatters
// and attenuates its light as that of the environment. Where nothing is in front of it, it is shown
// as it was photographed, by any view and at any exposure.
struct PlateBehind {
  int width = 0, height = 0;       // of a picture of the whole film, of any resolution
  std::vector<std::uint8_t> rgba;  // sRGB, rows from the top; A: how much of it is there
  double opacity = 1.0;            // the rest is the environment
};

// A row of a frame shows this of a plate, R, G, B per pixel; nothing of it where the frame has no
// transmittance.
struct PlateRow {
  std::vector<float> values;    // of a display, in [0, 1]
  std::vector<float> light;     // linear
  std::vector<float> shares;    // of it that are seen
  std::vector<float> replaced;  // radiance of the environment that is not
};
PlateRow plate_row(const PlateBehind& plate, const Frame& frame, std::size_t row);

}  // namespace brume
