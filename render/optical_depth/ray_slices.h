#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "render/simd/gaussian_kernels.h"

namespace brume {

// Slice boundaries at the corners, sides and center of a tile: 3 x 3 nodes, row-major, each with
// `count` ascending boundaries [u].
struct SliceNodes {
  std::array<const float*, 9> boundaries{};
  std::size_t count = 0;  // 0: no medium in the tile
};

// Slice boundaries t_0 <= t_1 <= ... [u] of a batch of rays.
class RaySlices {
 public:
  // Rays that are contiguous in memory; padded() rounds to it.
  static constexpr std::size_t group = 16;

  // Interpolates between the nodes of a tile; `positions` are the rays' positions in [0, 1]^2.
  void interpolate(const SliceNodes& nodes, std::span<const glm::vec2> positions,
                   const PathBatch& rays);
  // The same boundaries for all rays.
  void assign(std::span<const float> boundaries, const PathBatch& rays);

  // Cuts every slice into `parts` of equal length.
  void subdivide(std::size_t parts);

  // Boundaries of each ray.
  [[nodiscard]] std::size_t count() const { return count_; }
  // Boundary k of a ray and the following ones of its group, clamped to each ray's end.
  [[nodiscard]] const float* at(std::size_t ray, std::size_t k) const {
    return t_.data() + (ray / group * count_ + k) * group + ray % group;
  }
  // Minimum and maximum of each boundary in the group of a ray, not clamped.
  [[nodiscard]] std::span<const float> nearest(std::size_t ray) const {
    return std::span(nearest_).subspan(ray / group * count_, count_);
  }
  [[nodiscard]] std::span<const float> farthest(std::size_t ray) const {
    return std::span(farthest_).subspan(ray / group * count_, count_);
  }

 private:
  void resize(std::size_t count, const PathBatch& rays);

  std::size_t count_ = 0;
  std::vector<float> t_, nearest_, farthest_;
};

}  // namespace brume
