#pragma once

#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <span>
#include <vector>

#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"

namespace brume {

// Pixels around point lights in view. In-scattering grows there like 1 / distance, up to
// min_light_distance(); interpolation and random samples would miss it.
//
// The `width` x `width` pixels (>= 1) whose centers are nearest to each light's film position,
// clipped to the film, for lights in front of the eye. Occlusion is ignored. Each
// pixel once, in film order.
std::vector<glm::ivec2> light_pixels(std::span<const PointLight> lights, const CameraRays& rays,
                                     const Film& film, int width);

// At airlight scale 4, nothing is interpolated within a block of this width [pixels] around a
// light.
constexpr int light_block = 4;

// Pixels grouped by tile.
struct TilePixels {
  std::vector<std::uint32_t> offsets;  // first pixel of each tile, and the end
  std::vector<glm::ivec2> pixels;

  [[nodiscard]] std::span<const glm::ivec2> pixels_of(std::size_t tile) const {
    return std::span(pixels).subspan(offsets[tile], offsets[tile + 1] - offsets[tile]);
  }
};

// `samples`: the film of one sample per scale x scale pixels, plus one at its end.
TilePixels sort_into_tiles(std::vector<glm::ivec2> pixels, const Film& samples, int scale);

}  // namespace brume
