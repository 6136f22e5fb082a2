#include "core/scene/materials/texture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>
#include <utility>

#include "core/math/srgb.h"

namespace brume {
namespace {

using Encoding = Texture::Encoding;

constexpr float max_shared_exponent = 32768.0f;  // GLM's; RGB9E5 has twice as much

std::uint32_t byte_of(float x) {
  return static_cast<std::uint32_t>(std::lround(255.0f * std::clamp(x, 0.0f, 1.0f)));
}

std::uint32_t encode(const glm::vec4& value, Encoding encoding) {
  if (encoding == Encoding::shared_exponent) {
    return glm::packF3x9_E1x5(glm::clamp(glm::vec3(value), 0.0f, max_shared_exponent));
  }
  glm::vec4 v = value;
  if (encoding == Encoding::srgb) {
    for (int c = 0; c < 3; ++c) v[c] = srgb_encoded(v[c]);
  }
  return byte_of(v.r) | byte_of(v.g) << 8 | byte_of(v.b) << 16 | byte_of(v.a) << 24;
}

glm::vec4 decode(std::uint32_t texel, Encoding encoding) {
  if (encoding == Encoding::shared_exponent) {
    return {glm::unpackF3x9_E1x5(texel), 1.0f};
  }
  const auto byte = [texel](int c) { return texel >> 8 * c & 0xffu; };
  const auto fraction = [](std::uint32_t b) { return static_cast<float>(b) / 255.0f; };
  if (encoding == Encoding::linear) {
    return {fraction(byte(0)), fraction(byte(1)), fraction(byte(2)), fraction(byte(3))};
  }
  const std::array<float, 256>& linear = srgb_to_linear();
  return {linear[byte(0)], linear[byte(1)], linear[byte(2)], fraction(byte(3))};
}

std::vector<std::uint32_t> packed(std::span<const std::uint8_t> rgba) {
  std::vector<std::uint32_t> texels(rgba.size() / 4);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto byte = [&](std::size_t c) { return std::uint32_t{rgba[4 * i + c]}; };
    texels[i] = byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
  }
  return texels;
}

// The position in [0, 1] of the image that a coordinate shows. Beyond its ends `clamp` keeps going:
// the index of the texel is what is clamped.
double wrapped(double x, TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::repeat:
      return x - std::floor(x);
    case TextureWrap::clamp:
      return std::clamp(x, 0.0, 1.0);
    case TextureWrap::mirror: {
      const double fraction = x - 2.0 * std::floor(0.5 * x);  // in [0, 2)
      return fraction > 1.0 ? 2.0 - fraction : fraction;
    }
  }
  return 0.0;
}

// A neighbour's index, at most one beyond the ends.
int wrapped_index(int i, int size, TextureWrap wrap) {
  if (wrap == TextureWrap::repeat) return i < 0 ? i + size : i >= size ? i - size : i;
  return std::clamp(i, 0, size - 1);  // a mirrored image has its edge twice
}

// The texels of a row or column that one of half as many covers, and how much of each. An odd
// number is not halved exactly: up to four.
struct Cover {
  int first = 0;
  std::array<float, 4> weights{};

  Cover(int i, int fine, int coarse) {
    const double ratio = static_cast<double>(fine) / coarse;
    const double low = i * ratio;
    const double high = (i + 1) * ratio;
    first = static_cast<int>(low);
    for (int k = 0; k < 4; ++k) {
      const double texel = first + k;
      const double overlap = std::min(high, texel + 1.0) - std::max(low, texel);
      weights[static_cast<std::size_t>(k)] = static_cast<float>(std::max(0.0, overlap) / ratio);
    }
  }
};

}  // namespace

const std::array<float, 256>& srgb_to_linear() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = static_cast<float>(srgb_decoded(static_cast<double>(i) / 255.0));
    }
    return result;
  }();
  return table;
}

std::size_t Texture::texel_count(int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (width == 1 && height == 1) return count;
  return count + texel_count(std::max(1, width / 2), std::max(1, height / 2));
}

Texture::Texture(int width, int height, std::vector<std::uint32_t> texels, Encoding encoding)
    : encoding_(encoding), levels_{{width, height, 0}}, texels_(std::move(texels)) {
  assert(width > 0 && height > 0 && encoding != Encoding::shared_exponent);
  assert(texels_.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  add_levels();
}

Texture::Texture(int width, int height, std::span<const std::uint8_t> rgba, Encoding encoding)
    : Texture(width, height, packed(rgba), encoding) {}

Texture::Texture(int width, int height, std::span<const glm::vec3> radiance)
    : encoding_(Encoding::shared_exponent), levels_{{width, height, 0}} {
  assert(width > 0 && height > 0);
  assert(radiance.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  texels_.reserve(texel_count(width, height));
  for (const glm::vec3& value : radiance) texels_.push_back(encode({value, 1.0f}, encoding_));
  add_levels();
}

void Texture::add_levels() {
  texels_.reserve(texel_count(width(), height()));
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level fine = levels_.back();
    const Level coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), texels_.size()};
    texels_.resize(coarse.first + static_cast<std::size_t>(coarse.width) *
                                      static_cast<std::size_t>(coarse.height));
    tbb::parallel_for(0, coarse.height, [&](int y) {
      const Cover rows(y, fine.height, coarse.height);
      for (int x = 0; x < coarse.width; ++x) {
        const Cover columns(x, fine.width, coarse.width);
        glm::vec4 sum(0.0f);
        for (int j = 0; j < 4; ++j) {
          for (int i = 0; i < 4; ++i) {
            const float weight = rows.weights[static_cast<std::size_t>(j)] *
                                 columns.weights[static_cast<std::size_t>(i)];
            if (weight > 0.0f) sum += weight * texel(fine, columns.first + i, rows.first + j);
          }
        }
        texels_[coarse.first +
                static_cast<std::size_t>(y) * static_cast<std::size_t>(coarse.width) +
                static_cast<std::size_t>(x)] = encode(sum, encoding_);
      }
    });
    levels_.push_back(coarse);
  }
}

glm::vec4 Texture::texel(const Level& level, int x, int y) const {
  // Rounded weights may reach a little beyond the last.
  const auto column = static_cast<std::size_t>(std::min(x, level.width - 1));
  const auto row = static_cast<std::size_t>(std::min(y, level.height - 1));
  return decode(texels_[level.first + row * static_cast<std::size_t>(level.width) + column],
                encoding_);
}

glm::vec4 Texture::bilinear(const Level& level, const glm::dvec2& position, TextureWrap wrap_u,
                            TextureWrap wrap_v) const {
  const double x = position.x * level.width - 0.5;
  const double y = position.y * level.height - 0.5;
  const auto x0 = static_cast<int>(std::floor(x));
  const auto y0 = static_cast<int>(std::floor(y));
  const auto s = static_cast<float>(x - x0);
  const auto t = static_cast<float>(y - y0);
  const auto texel_at = [&](int i, int j) {
    return texel(level, wrapped_index(i, level.width, wrap_u),
                 wrapped_index(j, level.height, wrap_v));
  };
  return glm::mix(glm::mix(texel_at(x0, y0), texel_at(x0 + 1, y0), s),
                  glm::mix(texel_at(x0, y0 + 1), texel_at(x0 + 1, y0 + 1), s), t);
}

glm::vec4 Texture::lookup(const glm::dvec2& uv, double footprint, TextureWrap wrap_u,
                          TextureWrap wrap_v) const {
  const glm::dvec2 position(wrapped(uv.x, wrap_u), wrapped(1.0 - uv.y, wrap_v));
  const double texels = footprint * std::sqrt(static_cast<double>(width()) * height());
  const auto last = static_cast<double>(levels_.size() - 1);
  const double level = texels > 1.0 ? std::min(std::log2(texels), last) : 0.0;
  const auto below = static_cast<std::size_t>(level);
  const glm::vec4 fine = bilinear(levels_[below], position, wrap_u, wrap_v);
  const auto fraction = static_cast<float>(level - static_cast<double>(below));
  if (!(fraction > 0.0f)) return fine;
  return glm::mix(fine, bilinear(levels_[below + 1], position, wrap_u, wrap_v), fraction);
}

}  // namespace brume
