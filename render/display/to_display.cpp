#include "render/display/to_display.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "core/math/srgb.h"
#include "render/display/dither.h"
#include "render/display/neutral_view.h"

namespace brume {
namespace {

// See neutral_view.h.
std::array<float, 3> compress_highlights(std::array<float, 3> c) {
  using namespace highlight;
  const float low = std::min({c[0], c[1], c[2]});
  const float offset = low < knee ? low - slope * low * low : highlight::offset;
  for (float& x : c) x -= offset;
  const float peak = std::max({c[0], c[1], c[2]});
  if (peak < start) return c;
  const float room = 1.0f - start;
  const float new_peak = 1.0f - room * room / (peak + room - start);
  const float white = 1.0f - 1.0f / (desaturation * (peak - new_peak) + 1.0f);
  for (float& x : c) x = std::lerp(x * new_peak / peak, new_peak, white);
  return c;
}

// srgb_encoded() of [0, 1], interpolated: off by less than a tenth of the last of 16 bits.
class SrgbTable {
 public:
  SrgbTable() {
    for (std::uint32_t i = 0; i <= intervals; ++i) {
      values_[i] = srgb_encoded(static_cast<float>(i) / intervals);
    }
  }
  [[nodiscard]] float operator()(float x) const {
    const float place = std::clamp(x, 0.0f, 1.0f) * intervals;
    const auto i = static_cast<std::uint32_t>(place);
    return values_[i] + (place - static_cast<float>(i)) * (values_[i + 1] - values_[i]);
  }

 private:
  static constexpr std::uint32_t intervals = 1u << 16;
  std::vector<float> values_ = std::vector<float>(intervals + 2);  // the last is multiplied by 0
};

void apply_neutral_view(std::span<float> rgb) {
  static const SrgbTable encoded;
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    const std::array<float, 3> c = compress_highlights({rgb[i], rgb[i + 1], rgb[i + 2]});
    for (std::size_t k = 0; k < 3; ++k) rgb[i + k] = encoded(c[k]);
  }
}

void apply_view(const DisplayLook& look, std::vector<float>& row) {
  if (look.view) {
    look.view->apply(row);
  } else {
    apply_neutral_view(row);
  }
}

// Calls take(y, values) with the values that a display shows, in [0, 1], row by row.
template <class Take>
void for_each_row(const Frame& frame, const DisplayLook& look, Take&& take) {
  const float gain = exposure_gain(look.exposure);
  const auto width = static_cast<std::size_t>(frame.film.width);
  const std::size_t pixels = frame.beauty.size() / 4;
  std::vector<float> row(3 * width);
  PlateRow plate;
  for (std::size_t y = 0; y * width < pixels; ++y) {
    if (look.plate) plate = plate_row(*look.plate, frame, y);
    const float* beauty = &frame.beauty[4 * y * width];
    for (std::size_t k = 0; k < row.size(); ++k) {
      float radiance = beauty[4 * (k / 3) + k % 3];
      if (look.plate) radiance -= plate.replaced[k];
      row[k] = std::clamp(gain * radiance, 0.0f, brightest_shown);
      if (look.plate) row[k] += plate.shares[k] * plate.light[k];
    }
    apply_view(look, row);
    if (look.plate) {
      // The view must not change what is seen of the plate.
      apply_view(look, plate.light);
      for (std::size_t k = 0; k < row.size(); ++k) {
        row[k] += plate.shares[k] * (plate.values[k] - plate.light[k]);
      }
    }
    // A configuration may make anything of a colour, even no number.
    for (float& x : row) x = x > 0.0f ? std::min(x, 1.0f) : 0.0f;
    take(y, std::span<const float>(row));
  }
}

}  // namespace

std::string view_name(const DisplayLook& look) {
  if (!look.view) return "Khronos PBR Neutral, sRGB";
  return look.view->choice().view + ", " + look.view->choice().display;
}

glm::vec3 to_display(const glm::vec3& radiance, double exposure) {
  const float gain = exposure_gain(exposure);
  std::array<float, 3> c;
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = std::clamp(gain * radiance[static_cast<int>(k)], 0.0f, brightest_shown);
  }
  apply_neutral_view(c);
  return {c[0], c[1], c[2]};
}

std::vector<std::uint8_t> to_display(const Frame& frame, const DisplayLook& look) {
  const FilmRegion region = frame.film.region.value_or(FilmRegion{});
  const auto left = static_cast<std::uint32_t>(region.x);
  const auto top = static_cast<std::uint32_t>(region.y);
  std::vector<std::uint8_t> rgb(frame.beauty.size() / 4 * 3);
  for_each_row(frame, look, [&](std::size_t y, std::span<const float> values) {
    std::uint8_t* row = &rgb[y * values.size()];
    for (std::size_t x = 0; x < values.size() / 3; ++x) {
      const float threshold = dither_threshold(left + static_cast<std::uint32_t>(x),
                                               top + static_cast<std::uint32_t>(y));
      for (std::size_t k = 0; k < 3; ++k) {
        row[3 * x + k] = static_cast<std::uint8_t>(255.0f * values[3 * x + k] + threshold);
      }
    }
  });
  return rgb;
}

std::vector<std::uint16_t> to_display_16(const Frame& frame, const DisplayLook& look) {
  std::vector<std::uint16_t> rgb;
  rgb.reserve(frame.beauty.size() / 4 * 3);
  for_each_row(frame, look, [&](std::size_t, std::span<const float> values) {
    for (const float x : values) {
      rgb.push_back(static_cast<std::uint16_t>(std::lround(65535.0f * x)));
    }
  });
  return rgb;
}

}  // namespace brume
