#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/medium/medium.h"
#include "core/volume/density_grid.h"

namespace brume {

// Half the radius of the smallest Gaussian [u], 0 without any: between such voxels, linear
// interpolation is within 7% of that one's peak, and of larger ones less as the square of their
// radius.
double fitting_voxel_size(const Medium& medium);

// The Gaussians of a medium on a grid, for programs that know nothing else: the densities at the
// points voxel_size * (i, j, k) of the world, in the blocks that a Gaussian reaches; beyond three
// radii, where it is 1e-4 of its peak, it is left out. b0 is not part of it: it has no bounds.
class MediumSampling {
 public:
  // Finds the blocks; nullopt where there are more than `most`, or where so many Gaussians reach
  // each that listing them takes more memory than `most` blocks. voxel_size > 0.
  static std::optional<MediumSampling> plan(const Medium& medium, double voxel_size,
                                            std::size_t most);

  [[nodiscard]] std::size_t blocks() const { return corners_.size(); }
  [[nodiscard]] std::uintmax_t bytes() const {
    return blocks() * sizeof(DensityGrid::Block) + pairs_ * sizeof(std::uint32_t);
  }

  // In parallel; nullopt when it was stopped. Same input, same result. The medium lives on.
  [[nodiscard]] std::optional<DensityGrid> sample(
      const std::stop_token& stop = {}, const std::function<void(double)>& progress = {}) const;

 private:
  MediumSampling(const Medium& medium, double voxel_size)
      : medium_(&medium), voxel_size_(voxel_size) {}

  const Medium* medium_;
  double voxel_size_;
  std::vector<glm::ivec3> corners_;
  std::vector<std::vector<std::uint32_t>> gaussians_;  // of each block
  std::size_t pairs_ = 0;                              // in all of them
};

// The first size that plan() takes among those each twice the last, in two digits; nullopt where
// voxel_size itself is beyond 1e12.
std::optional<double> sufficient_voxel_size(const Medium& medium, double voxel_size,
                                            std::size_t most);

}  // namespace brume
