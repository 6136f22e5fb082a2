#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/materials/texture.h"

namespace brume {

inline std::shared_ptr<const Texture> picture(int side, auto&& texel) {
  std::vector<std::uint32_t> texels;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) texels.push_back(0xff000000u | texel(x, y));
  }
  return std::make_shared<const Texture>(side, side, std::move(texels), Texture::Encoding::linear);
}

// Red and green above, blue and white below.
inline std::shared_ptr<const Texture> quadrants_picture() {
  return picture(64, [](int x, int y) -> std::uint32_t {
    return y < 32 ? (x < 32 ? 0x0000ffu : 0x00ff00u) : (x < 32 ? 0xff0000u : 0xffffffu);
  });
}

// A white disc of half the picture's width.
inline std::shared_ptr<const Texture> disc_picture() {
  return picture(64, [](int x, int y) -> std::uint32_t {
    return (2 * x - 63) * (2 * x - 63) + (2 * y - 63) * (2 * y - 63) < 32 * 32 ? 0xffffffu : 0u;
  });
}

}  // namespace brume
