#pragma once

#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <span>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace brume {

// The pixels of a film nearest to point lights in view. Airlight grows there like 1 / distance from
// where a light is seen, up to least_light_distance(); interpolation misses it, and a sample of
// the frame may.
//
// The `width` x `width` pixels, >= 1, whose centres are nearest to each light's film position, as
// far as they are on the film; of lights that shine and stand before the eye. Surfaces that hide a
// light are not asked. Each pixel once, in the film's order.
std::vector<glm::ivec2> light_pixels(std::span<const PointLight> lights, const CameraRays& rays,
                                     const Film& film, int width);

// Airlight at 1 / 4 is computed every fourth pixel; for so many around a light nothing is
// interpolated.
constexpr int light_block = 4;

// Pixels by the tile whose samples tell them.
struct TilePixels {
  std::vector<std::uint32_t> offsets;  // of each tile's, and the end
  std::vector<glm::ivec2> pixels;

  [[nodiscard]] std::span<const glm::ivec2> of(std::size_t tile) const {
    return std::span(pixels).subspan(offsets[tile], offsets[tile + 1] - offsets[tile]);
  }
};

// `samples`: the film of one sample for scale x scale pixels, and one more at its end.
TilePixels sort_into_tiles(std::vector<glm::ivec2> pixels, const Film& samples, int scale);

}  // namespace brume
