#include "render/display/plate_behind.h"

#include <array>

#include "core/math/srgb.h"

namespace brume {
namespace {

const std::array<float, 256>& decoded_bytes() {
  static const auto values = [] {
    std::array<float, 256> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = srgb_decoded(static_cast<float>(i) / 255.0f);
    }
    return all;
  }();
  return values;
}

}  // namespace

PlateRow plate_row(const PlateBehind& plate, const Frame& frame, std::size_t row) {
  const auto width = static_cast<std::size_t>(frame.film.width);
  const auto height = static_cast<std::size_t>(frame.film.height);
  const auto plate_width = static_cast<std::size_t>(plate.width);
  const std::size_t plate_y = row * static_cast<std::size_t>(plate.height) / height;
  const std::vector<float> none(3 * width, 0.0f);
  PlateRow result{none, none, none, none};
  if (frame.transmittance.empty()) return result;  // a layer by itself has nothing behind it
  for (std::size_t x = 0; x < width; ++x) {
    const std::size_t pixel = row * width + x;
    const std::uint8_t* rgba = &plate.rgba[4 * (plate_y * plate_width + x * plate_width / width)];
    const float share = static_cast<float>(plate.opacity) * static_cast<float>(rgba[3]) / 255.0f;
    const float* transmittance = &frame.transmittance[3 * pixel];
    const float mean = (transmittance[0] + transmittance[1] + transmittance[2]) / 3.0f;
    // Alpha knows what surfaces cover of the pixel, the transmittance what colour is left.
    const float open = mean > 0.0f ? share * (1.0f - frame.beauty[4 * pixel + 3]) / mean : 0.0f;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t k = 3 * x + c;
      result.values[k] = static_cast<float>(rgba[c]) / 255.0f;
      result.light[k] = decoded_bytes()[rgba[c]];
      result.shares[k] = open * transmittance[c];
      if (!frame.background.empty()) result.replaced[k] = share * frame.background[3 * pixel + c];
    }
  }
  return result;
}

}  // namespace brume
