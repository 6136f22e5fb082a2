#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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
  bool operator==(const GridNodes&) const = default;
};

constexpr glm::ivec3 node_coordinates(const GridNodes& nodes, std::size_t node) {
  const int k = static_cast<int>(node);
  return {k % nodes.count.x, k / nodes.count.x % nodes.count.y,
          k / (nodes.count.x * nodes.count.y)};
}

constexpr std::size_t node_index(const GridNodes& nodes, const glm::ivec3& p) {
  const auto index = [](int k) { return static_cast<std::size_t>(k); };
  return (index(p.z) * index(nodes.count.y) + index(p.y)) * index(nodes.count.x) + index(p.x);
}

// A node that surfaces hide neighbours from, or beside one: there, polynomials of four values would
// reach through surfaces.
struct OccludedNode {
  std::uint32_t blocked = 0;  // bit neighbour_index() of each neighbour that is hidden
  std::uint32_t first = 0;    // of its links, in the order of the bits
};

// The neighbour of a node at an offset of -1, 0 or 1 along each axis.
constexpr int neighbour_index(int x, int y, int z) {
  return (z + 1) * 9 + (y + 1) * 3 + x + 1;
}
constexpr glm::ivec3 neighbour_offset(int index) {
  return {index % 3 - 1, index / 3 % 3 - 1, index / 9 - 1};
}

// Surfaces between the nodes of a grid; see GridOcclusion.
struct SweepOcclusion {
  std::span<const std::int32_t> index;  // per grid node, in `nodes` or -1; empty: no surfaces
  std::span<const OccludedNode> nodes;
  std::span<const float> fractions;  // per hidden neighbour, of the way to it
  std::span<const float> passing;    // the same, share of light that panes let through; empty: none
  // Whether a grid node sees what light comes from, beyond the grid; empty: only nodes tell.
  std::function<bool(std::size_t node)> is_lit;

  [[nodiscard]] bool empty() const { return index.empty(); }
};

// transmittance[i] = exp(-optical depth) from node i along the unit vector w to the grid's border,
// empty beyond; 0 behind surfaces. Unless `inflow` is empty, light that enters the grid arrives at
// nodes of its border with inflow[i] in place of 1. At the edges of shadows beside surfaces,
// `is_lit` decides: from node to node, light through a window of a few nodes loses a tenth at its
// edges. Thread-safe.
void sweep_transmittance(const GridNodes& nodes, std::span<const float> density, const glm::vec3& w,
                         const SweepOcclusion& occlusion, std::span<const float> inflow,
                         std::span<float> transmittance);

// emitted[c][i] = radiance arriving at node i from direction w, for one or three channels c: the
// integral of density times source[c], attenuated by density + fog, from the first surface on,
// whose radiance is outgoing[c] per hidden neighbour; empty: black. Empty beyond the grid; if the
// medium continues there, nothing of what it emits. Thread-safe.
void sweep_emission(const GridNodes& nodes, std::span<const float> density, float fog,
                    bool continues, std::span<const std::span<const float>> source,
                    const glm::vec3& w, const SweepOcclusion& occlusion,
                    std::span<const std::span<const float>> outgoing,
                    std::span<const std::span<float>> emitted);

// sums[c][i] += sum over k of transmittances[k][i] * weights[k][c], for nodes i in [begin, end),
// multiples of 16. Rows of `transmittances` and `sums` have `stride` >= end elements.
void add_weighted(std::span<const float> transmittances, std::span<const float> weights,
                  std::size_t channels, std::size_t stride, std::size_t begin, std::size_t end,
                  std::span<float> sums);

inline void add(std::span<const float> values, std::span<float> sums) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += values[i];
}

}  // namespace brume
