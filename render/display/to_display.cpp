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
float encoded(float x) {
  constexpr std::size_t intervals = 1u << 16;
  static const auto table = [] {
    std::vector<float> values(intervals + 2);  // the last one is only multiplied by 0
    for (std::size_t i = 0; i <= intervals; ++i) {
      values[i] = srgb_encoded(static_cast<float>(i) / intervals);
    }
    return values;
  }();
  const float place = std::clamp(x, 0.0f, 1.0f) * intervals;
  const auto i = static_cast<std::size_t>(place);
  return table[i] + (place - static_cast<float>(i)) * (table[i + 1] - table[i]);
}

void apply_neutral_view(std::span<float> rgb) {
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    const std::array<float, 3> c = compress_highlights({rgb[i], rgb[i + 1], rgb[i + 2]});
    for (std::size_t k = 0; k < 3; ++k) rgb[i + k] = encoded(c[k]);
  }
}

// Calls take(y, values) with the values that a display shows, in [0, 1], row by row.
template <class Take>
void for_each_row(const Frame& frame, const DisplayLook& look, Take&& take) {
  const float gain = exposure_gain(look.exposure);
  const auto width = static_cast<std::size_t>(frame.film.width);
  const std::size_t pixels = frame.beauty.size() / 4;
  std::vector<float> row(3 * width);
  for (std::size_t y = 0; y * width < pixels; ++y) {
    const float* beauty = &frame.beauty[4 * y * width];
    for (std::size_t i = 0; i < row.size(); ++i) {
      row[i] = std::clamp(gain * beauty[i / 3 * 4 + i % 3], 0.0f, brightest_shown);
    }
    if (look.view) {
      look.view->apply(row);
    } else {
      apply_neutral_view(row);
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
  c = compress_highlights(c);
  return {encoded(c[0]), encoded(c[1]), encoded(c[2])};
}

std::vector<std::uint8_t> to_display(const Frame& frame, const DisplayLook& look) {
  const FilmRegion region = frame.film.region.value_or(FilmRegion{});
  std::vector<std::uint8_t> rgb;
  rgb.reserve(frame.beauty.size() / 4 * 3);
  for_each_row(frame, look, [&](std::size_t y, std::span<const float> values) {
    const auto row = static_cast<std::uint32_t>(region.y) + static_cast<std::uint32_t>(y);
    for (std::size_t i = 0; i < values.size(); i += 3) {
      const auto column = static_cast<std::uint32_t>(region.x) + static_cast<std::uint32_t>(i / 3);
      const float threshold = dither_threshold(column, row);
      for (std::size_t k = 0; k < 3; ++k) {
        rgb.push_back(static_cast<std::uint8_t>(255.0f * values[i + k] + threshold));
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
