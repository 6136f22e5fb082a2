#pragma once

#include <cmath>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "core/scene/materials/brdf.h"
#include "core/scene/materials/measured_brdf.h"

namespace brume {

// The bytes of a MERL .binary that tabulates a material at the middles of its cells; -1 where light
// or eye is below the surface.
inline std::string merl_of(const Material& material) {
  constexpr double half_pi = 0.5 * std::numbers::pi;
  constexpr double scale[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
  const std::int32_t dims[3] = {90, 90, 180};
  std::vector<double> values(3 * MeasuredBrdf::samples);
  std::size_t at = 0;
  for (int i = 0; i < dims[0]; ++i) {
    const double x = (i + 0.5) / dims[0];
    const glm::dquat turn = glm::angleAxis(half_pi * x * x, glm::dvec3(0, 1, 0));
    const glm::dvec3 h = turn * glm::dvec3(0, 0, 1);
    for (int j = 0; j < dims[1]; ++j) {
      const double theta = half_pi * (j + 0.5) / dims[1];
      for (int k = 0; k < dims[2]; ++k, ++at) {
        const double phi = std::numbers::pi * (k + 0.5) / dims[2];
        const glm::dvec3 wi = turn * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                std::sin(theta) * std::sin(phi), std::cos(theta));
        const glm::dvec3 wo = 2.0 * glm::dot(wi, h) * h - wi;
        const bool is_above = wi.z > 0.0 && wo.z > 0.0;
        const glm::dvec3 f = is_above ? brdf(material, wi, wo, {0, 0, 1}) : glm::dvec3(-1.0);
        for (int c = 0; c < 3; ++c) {
          values[static_cast<std::size_t>(c) * MeasuredBrdf::samples + at] = f[c] / scale[c];
        }
      }
    }
  }
  std::string bytes(reinterpret_cast<const char*>(dims), sizeof(dims));
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
  return bytes;
}

}  // namespace brume
