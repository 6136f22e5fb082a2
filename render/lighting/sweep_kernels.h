#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace brume {

// SIMD kernels of SourceGrid (Highway, single precision). Nodes are stored x fastest, then y, then
// z. A grid is swept slab by slab from the side that light comes from; values of the previous slab
// are interpolated by cubic polynomials.

struct GridNodes {
  glm::ivec3 count{2};   // along each axis
  float spacing = 1.0f;  // [u]

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
           static_cast<std::size_t>(count.z);
  }
};

// transmittance[i] = exp(-optical depth) from node i along the unit vector w to the grid's border,
// empty beyond. Thread-safe.
void sweep_transmittance(const GridNodes& nodes, std::span<const float> density, const glm::vec3& w,
                         std::span<float> transmittance);

// emitted[c][i] = radiance arriving at node i from direction w, for c = R, G, B: the integral of
// density times source[c], attenuated by density + fog. Empty beyond the grid. Thread-safe.
void sweep_emission(const GridNodes& nodes, std::span<const float> density, float fog,
                    const std::array<std::span<const float>, 3>& source, const glm::vec3& w,
                    const std::array<std::span<float>, 3>& emitted);

// sums[c][i] += sum over k of transmittances[k][i] * weights[k][c], for nodes i in [begin, end),
// multiples of 16. Rows of `transmittances` and `sums` have `stride` >= end elements.
void add_weighted(std::span<const float> transmittances, std::span<const float> weights,
                  std::size_t channels, std::size_t stride, std::size_t begin, std::size_t end,
                  std::span<float> sums);

}  // namespace brume
