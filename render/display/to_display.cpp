#include "render/display/to_display.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "core/math/srgb.h"
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

float encoded(float x) {
  return srgb_encoded(std::clamp(x, 0.0f, 1.0f));
}

std::uint8_t srgb_byte(float x) {
  return static_cast<std::uint8_t>(std::lround(255.0f * encoded(x)));
}

// See ColorView. In rows, which are few enough for their memory to stay near.
std::vector<std::uint8_t> in_view(const Frame& frame, float gain, const ColorView& view) {
  constexpr std::size_t row = 1024;
  const std::size_t pixels = frame.beauty.size() / 4;
  std::vector<std::uint8_t> rgb(3 * pixels);
  std::vector<float> values(3 * row);
  for (std::size_t first = 0; first < pixels; first += row) {
    const std::size_t count = std::min(row, pixels - first);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        values[3 * i + k] =
            std::clamp(gain * frame.beauty[4 * (first + i) + k], 0.0f, brightest_shown);
      }
    }
    view.apply(std::span(values).first(3 * count));
    for (std::size_t i = 0; i < 3 * count; ++i) {
      // A configuration may make anything of a colour, even no number.
      const float x = values[i] > 0.0f ? std::min(values[i], 1.0f) : 0.0f;
      rgb[3 * first + i] = static_cast<std::uint8_t>(std::lround(255.0f * x));
    }
  }
  return rgb;
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
  const float gain = exposure_gain(look.exposure);
  if (look.view) return in_view(frame, gain, *look.view);
  // sRGB bytes of even steps of [0, 1], finer than a byte even in the darkest values, whose slope
  // is srgb::slope.
  static const auto table = [] {
    std::array<std::uint8_t, 8193> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = srgb_byte(static_cast<float>(i) / static_cast<float>(bytes.size() - 1));
    }
    return bytes;
  }();
  const std::size_t pixels = frame.beauty.size() / 4;
  std::vector<std::uint8_t> rgb(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    std::array<float, 3> c;
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = std::clamp(gain * frame.beauty[4 * i + k], 0.0f, brightest_shown);
    }
    c = compress_highlights(c);
    for (std::size_t k = 0; k < 3; ++k) {
      const float x = std::clamp(c[k], 0.0f, 1.0f) * static_cast<float>(table.size() - 1);
      // lround() would take longer than all else here.
      rgb[3 * i + k] =
          table[static_cast<std::size_t>(x + 0.5f)];  // NOLINT(bugprone-incorrect-roundings)
    }
  }
  return rgb;
}

}  // namespace brume
