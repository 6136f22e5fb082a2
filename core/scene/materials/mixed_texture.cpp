#include "core/scene/materials/mixed_texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/math/srgb.h"

namespace brume {
namespace {

std::uint8_t to_byte(float x) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(x, 0.0f, 1.0f)));
}

}  // namespace

bool has_alpha(const Texture& texture) {
  if (texture.encoding() == Texture::Encoding::shared_exponent) return false;
  return std::ranges::any_of(texture.texels(),
                             [](std::uint32_t texel) { return texel >> 24 != 0xffu; });
}

std::shared_ptr<const Texture> mixed_texture(
    const Texture* a, const Texture* b,
    const std::function<glm::vec4(const glm::vec4&, const glm::vec4&)>& mix) {
  const int width = std::max(a ? a->width() : 1, b ? b->width() : 1);
  const int height = std::max(a ? a->height() : 1, b ? b->height() : 1);
  std::vector<std::uint8_t> rgba;
  rgba.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec2 uv((x + 0.5) / width, 1.0 - (y + 0.5) / height);
      const auto texel = [&uv](const Texture* texture) {
        if (!texture) return glm::vec4(1.0f);
        return texture->lookup(uv, 0.0, TextureWrap::clamp, TextureWrap::clamp);
      };
      const glm::vec4 value = mix(texel(a), texel(b));
      for (int c = 0; c < 3; ++c) {
        rgba.push_back(to_byte(srgb_encoded(std::clamp(value[c], 0.0f, 1.0f))));
      }
      rgba.push_back(to_byte(value.a));
    }
  }
  return std::make_shared<Texture>(width, height, rgba, Texture::Encoding::srgb);
}

}  // namespace brume
