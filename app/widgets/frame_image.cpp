#include "app/widgets/frame_image.h"

#include <cstring>
#include <vector>

namespace brume {

QImage frame_image(const Frame& frame, const DisplayLook& look) {
  const std::vector<std::uint8_t> bytes = to_display(frame, look);
  QImage image(frame.film.width, frame.film.height, QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(frame.film.width) * 3;
  for (int y = 0; y < frame.film.height; ++y) {
    std::memcpy(image.scanLine(y), bytes.data() + static_cast<std::size_t>(y) * row, row);
  }
  return image;
}

}  // namespace brume
