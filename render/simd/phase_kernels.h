#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

namespace brume {

// Light from one direction, as single precision has it.
struct PhasedLight {
  glm::vec3 direction;   // towards it, unit
  glm::vec3 irradiance;  // RGB [W/u^2]
};

// sums[c][k] += what all lights send on towards the unit direction (x[k], y[k], z[k]), for channels
// c: irradiance[c] times Henyey and Greenstein's phase function [1/sr] (Highway). Relative error
// 1e-5, in its peak too. The arrays have padded() elements, see kernels.h. Thread-safe.
void add_phased(std::span<const PhasedLight> lights, double anisotropy,
                const std::array<std::span<const float>, 3>& directions,
                const std::array<std::span<float>, 3>& sums);

}  // namespace brume
