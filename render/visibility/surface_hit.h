#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace brume {

// The nearest hit of a ray, compact: on a surface, or where view rays and mirrored ones meet a
// light that is seen (LightShapes), on that.
struct SurfaceHit {
  double distance = std::numeric_limits<double>::infinity();
  std::int32_t surface = -1;  // index; -1 for none, below for lights
  std::uint32_t triangle = 0;
  float u = 0.0f, v = 0.0f;  // barycentric, of the triangle's second and third corner
  std::uint32_t copy = 0;    // the placement, see placement_of()

  explicit operator bool() const { return surface != -1; }

  // The hit on a light, by its index in LightShapes.
  static SurfaceHit on_light(double distance, std::size_t light) {
    return {.distance = distance, .surface = first_light - static_cast<std::int32_t>(light)};
  }
  [[nodiscard]] bool is_light() const { return surface <= first_light; }
  [[nodiscard]] std::size_t light() const {
    return static_cast<std::size_t>(first_light - surface);
  }

 private:
  static constexpr std::int32_t first_light = -2;
};

}  // namespace brume
