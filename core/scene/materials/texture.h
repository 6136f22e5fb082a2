#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "brume/metallic_roughness.h"

namespace brume {

// An image and its mip chain, each level half as wide and high as the one before, down to one
// texel. A texel takes 32 bits: RGBA of 8 bits each, or RGB with a common exponent (RGB9E5).
// Averages, of levels and between texels, are of linear light. Immutable.
class Texture {
 public:
  enum class Encoding : std::uint32_t {
    srgb,    // R, G, B are sRGB-encoded, A is linear
    linear,  // all are
    shared_exponent
  };

  // RGBA of width * height pixels, 4 bytes each, rows from the top; `encoding` is srgb or linear.
  // Takes no more memory where the texels have room for texel_count().
  Texture(int width, int height, std::vector<std::uint32_t> texels, Encoding encoding);
  Texture(int width, int height, std::span<const std::uint8_t> rgba, Encoding encoding);
  // Radiance, clamped to [0, 32768].
  Texture(int width, int height, std::span<const glm::vec3> radiance);

  [[nodiscard]] int width() const { return levels_[0].width; }
  [[nodiscard]] int height() const { return levels_[0].height; }
  [[nodiscard]] Encoding encoding() const { return encoding_; }

  // The texels of all levels.
  [[nodiscard]] static std::size_t texel_count(int width, int height);

  struct Level {
    int width = 0;
    int height = 0;
    std::size_t first = 0;  // in texels(); rows from the top
  };
  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }
  [[nodiscard]] std::span<const std::uint32_t> texels() const { return texels_; }
  [[nodiscard]] std::size_t bytes() const { return texels_.size() * sizeof(std::uint32_t); }

  // Linear RGBA.
  [[nodiscard]] glm::vec4 texel(const Level& level, int x, int y) const;

  // Linear RGBA at texture coordinates (u to the right, v up), averaged over about a square of side
  // `footprint` there: trilinear, from the two levels whose texels are next to it in size; 0: from
  // the image itself. Coordinates and footprint must be finite.
  [[nodiscard]] glm::vec4 lookup(const glm::dvec2& uv, double footprint, TextureWrap wrap_u,
                                 TextureWrap wrap_v) const;

  // The average of the whole image.
  [[nodiscard]] glm::vec4 average() const { return texel(levels_.back(), 0, 0); }

 private:
  [[nodiscard]] glm::vec4 bilinear(const Level& level, const glm::dvec2& position,
                                   TextureWrap wrap_u, TextureWrap wrap_v) const;
  void add_levels();

  Encoding encoding_;
  std::vector<Level> levels_;
  std::vector<std::uint32_t> texels_;
};

// Linear light of an sRGB-encoded value of 8 bits.
const std::array<float, 256>& srgb_to_linear();

}  // namespace brume
