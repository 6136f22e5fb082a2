#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/scene/lights/radiance_map.h"

namespace brume {

// SIMD kernels of compositing (Highway, single precision), one row of pixels at a time.

// Directions through the pixels of a row, of any length, in the frame of a map: start + (first + k)
// per_pixel.
struct RowDirections {
  glm::vec3 start{0.0f};
  glm::vec3 per_pixel{0.0f};
  int first = 0;
};

// behind[k] = scale * the map's radiance in direction k, where distances[k] is infinite. Scalar
// counterpart: environment_radiance(); positions on the map are off by 1e-6 of its width.
void find_sky(const RadianceMap& map, float scale, const RowDirections& directions,
              std::span<const float> distances, std::span<glm::vec3> behind);

// One row of a Frame's layers.
struct RowLayers {
  std::span<const float> airlight;       // RGB
  std::span<const float> transmittance;  // RGB
  std::span<const float> depth;
};

// Eq. 29: beauty (RGBA) = airlight + transmittance * behind, made finite().
void composite_row(const RowLayers& layers, std::span<const glm::vec3> behind,
                   std::span<float> beauty);

}  // namespace brume
