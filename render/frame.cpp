#include "render/frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/view_transform.h"

namespace brume {
namespace {

// See view_transform.h.
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

std::uint8_t srgb_byte(float x) {
  x = std::clamp(x, 0.0f, 1.0f);
  const float encoded = x <= srgb::knee
                            ? srgb::slope * x
                            : srgb::gain * std::pow(x, 1.0f / srgb::exponent) - srgb::offset;
  return static_cast<std::uint8_t>(std::lround(255.0f * encoded));
}

}  // namespace

void add_time(std::vector<StageTime>& stages, Stage stage, double milliseconds) {
  const auto known = std::ranges::find(stages, stage, &StageTime::stage);
  if (known == stages.end()) {
    stages.push_back({stage, milliseconds});
  } else {
    known->milliseconds += milliseconds;
  }
}

std::optional<RelativeNoise> relative_noise(const Frame& frame) {
  const std::optional<PathNoise>& noise = frame.statistics.path_noise;
  if (!noise) return std::nullopt;
  // `stride` values per pixel, the first three of which count.
  const auto relative = [](double variance, const std::vector<float>& layer, std::size_t stride) {
    double square = 0.0;
    for (std::size_t i = 0; i < layer.size(); i += stride) {
      for (std::size_t c = 0; c < 3; ++c) {
        square += static_cast<double>(layer[i + c]) * static_cast<double>(layer[i + c]);
      }
    }
    return square > 0.0 ? std::sqrt(variance / square) : 0.0;
  };
  return RelativeNoise{
      noise->paths, relative(noise->airlight_variance, frame.airlight, 3),
      relative(noise->airlight_variance + noise->surface_variance, frame.beauty, 4)};
}

ImageLayers to_layers(const Frame& frame) {
  ImageLayers image;
  image.width = frame.film.width;
  image.height = frame.film.height;
  const auto split = [&](const std::vector<float>& pixels,
                         std::initializer_list<const char*> names) {
    const std::size_t stride = names.size();
    std::size_t k = 0;
    for (const char* name : names) {
      std::vector<float>& channel = image.channels[name];
      channel.resize(pixels.size() / stride);
      for (std::size_t i = 0; i < channel.size(); ++i) channel[i] = pixels[i * stride + k];
      ++k;
    }
  };
  split(frame.beauty, {"R", "G", "B", "A"});
  split(frame.airlight, {"airlight.R", "airlight.G", "airlight.B"});
  split(frame.transmittance, {"transmittance.R", "transmittance.G", "transmittance.B"});
  split(frame.depth, {"Z"});
  return image;
}

float exposure_gain(double stops) {
  // Sixty stops make anything black or white; more would overflow, and NaN is no exposure.
  return static_cast<float>(std::exp2(std::isfinite(stops) ? std::clamp(stops, -60.0, 60.0) : 0.0));
}

std::vector<std::uint8_t> to_display(const Frame& frame, double exposure) {
  // sRGB bytes of even steps of [0, 1], finer than a byte even in the darkest values, whose slope
  // is srgb::slope.
  static const auto table = [] {
    std::array<std::uint8_t, 8193> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = srgb_byte(static_cast<float>(i) / static_cast<float>(bytes.size() - 1));
    }
    return bytes;
  }();
  const float gain = exposure_gain(exposure);
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
