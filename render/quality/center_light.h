#pragma once

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "brume/frame.h"

namespace brume {

// A picture is measured by paths of all orders of scattering and reflection.
enum class Measured { airlight, airlight_and_picture };

// The light of rays through the centers of a frame's pixels, by which its error is measured.
struct CenterLight {
  const Film& film;
  const std::vector<float>& values;
  std::size_t channels;  // RGB, or RGBA

  static CenterLight airlight(const Frame& frame) {
    return {frame.film, frame.center_airlight(), 3};
  }
  static CenterLight picture(const Frame& frame) { return {frame.film, frame.center_beauty(), 4}; }

  [[nodiscard]] std::size_t pixels() const { return values.size() / channels; }
  [[nodiscard]] glm::dvec3 at(std::size_t pixel) const {
    const float* rgb = &values[channels * pixel];
    return {rgb[0], rgb[1], rgb[2]};
  }
  // The square of a pixel, over RGB.
  [[nodiscard]] double square(std::size_t pixel) const {
    const glm::dvec3 radiance = at(pixel);
    return glm::dot(radiance, radiance);
  }
};

}  // namespace brume
