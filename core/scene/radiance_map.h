#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/math/spherical_harmonics.h"

namespace brume {

// Radiance from every direction as a latitude-longitude image: the top row looks along +y, the
// middle column along -z, columns grow to the right as seen from inside, so that the right half is
// +x. Linear RGB; finite and >= 0 wherever it was read from a file.
struct RadianceMap {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;  // rows from the top

  [[nodiscard]] const glm::vec3& pixel(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

// The film position in [0, width] x [0, height] that a unit direction falls on, and back. The
// centre of pixel (x, y) is (x + 0.5, y + 0.5).
glm::dvec2 map_position(const RadianceMap& map, const glm::dvec3& direction);
glm::dvec3 map_direction(const RadianceMap& map, const glm::dvec2& position);

// Bilinear between the pixels around a unit direction; columns close around, rows end at the poles.
// In single precision positions are off by 1e-6 of the width.
glm::dvec3 map_radiance(const RadianceMap& map, const glm::dvec3& direction);
glm::vec3 map_radiance(const RadianceMap& map, const glm::vec3& direction);

// The projection of the map on spherical harmonics, exact for pixels of constant radiance.
ShVector<glm::dvec3> map_sh(const RadianceMap& map, int order);

}  // namespace brume
