#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/math/spherical_harmonics.h"

namespace brume {

// A latitude-longitude radiance map: the top row is +y, the center column -z, columns run to the
// right as seen from inside, so the right half is +x. Linear RGB; finite and >= 0 if read from a
// file.
struct RadianceMap {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;  // rows from the top

  [[nodiscard]] const glm::vec3& pixel(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

// Maps a unit direction to a position in [0, width] x [0, height], and back. The center of pixel
// (x, y) is (x + 0.5, y + 0.5).
glm::dvec2 map_position(const RadianceMap& map, const glm::dvec3& direction);
glm::dvec3 map_direction(const RadianceMap& map, const glm::dvec2& position);

// Bilinear look-up; wraps around horizontally, clamps at the poles. In single precision positions
// are off by 1e-6 of the width.
glm::dvec3 map_radiance(const RadianceMap& map, const glm::dvec3& direction);
glm::vec3 map_radiance(const RadianceMap& map, const glm::vec3& direction);

// Projection on spherical harmonics, exact for piecewise constant pixels.
ShVector<glm::dvec3> map_sh(const RadianceMap& map, int order);

}  // namespace brume
