#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace brume {

// Radiance RGB on a triangle as a quadratic of the barycentric coordinates of its second and third
// corner, in 16 bits a coefficient: to 1/10,000 of the greatest of them.
struct RadiancePatch {
  RadiancePatch() = default;
  // Through the values at the corners and at the middles of the edges from each to the next.
  explicit RadiancePatch(const std::array<glm::vec3, 6>& values);

  // The plain version. >= 0.
  [[nodiscard]] glm::vec3 at(float u, float v) const {
    const std::array<float, 6> powers{1.0f, u, v, u * u, u * v, v * v};
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < powers.size(); ++i) {
      const std::int16_t* c = &coefficients[3 * i];
      sum += powers[i] * glm::vec3(c[0], c[1], c[2]);
    }
    return glm::max(unit * sum, 0.0f);
  }

  float unit = 0.0f;
  std::array<std::int16_t, 20> coefficients{};  // R G B of each power, in units; two of padding
};

// at() of many, radiance[k] = patches[k]->at(uv[k]), in single precision SIMD (Highway).
void evaluate_patches(std::span<const RadiancePatch* const> patches, std::span<const glm::vec2> uv,
                      std::span<glm::vec3> radiance);

}  // namespace brume
