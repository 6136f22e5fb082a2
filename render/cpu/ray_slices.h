#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "render/cpu/kernels.h"

namespace brume {

// The boundaries of slices at the corners, the sides and in the middle of a tile: 3 x 3 nodes row
// by row, each with `count` ascending boundaries [u].
struct SliceNodes {
  std::array<const float*, 9> boundaries{};
  std::size_t count = 0;  // 0: there is no medium in the tile
};

// Where the slices of a batch of rays begin and end: for each ray boundaries t_0 <= t_1 <= ... [u].
class RaySlices {
 public:
  // So many rays lie together in memory, as padded() has room for.
  static constexpr std::size_t group = 16;

  // Between the nodes of a tile; a place for each ray, from (0, 0) to (1, 1).
  void interpolate(const SliceNodes& nodes, std::span<const glm::vec2> places,
                   const PathBatch& rays);
  // The same boundaries for all rays.
  void assign(std::span<const float> boundaries, const PathBatch& rays);

  // Boundaries of each ray.
  [[nodiscard]] std::size_t count() const { return count_; }
  // Boundary k of a ray and of those after it in its group, no farther than each ray's end.
  [[nodiscard]] const float* at(std::size_t ray, std::size_t k) const {
    return t_.data() + (ray / group * count_ + k) * group + ray % group;
  }
  // The nearest and the farthest of each boundary in the group of a ray, whose ends do not count.
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
