#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "brume/density_grid.h"
#include "brume/medium.h"

namespace brume {

// Half the smallest radius [u], 0 without Gaussians: at that spacing trilinear interpolation errs
// by at most 7% of the smallest Gaussian's peak, and less for larger ones, as the square of their
// radius.
double fitting_voxel_size(const Medium& medium);

// Samples the Gaussians of a medium on a sparse grid, for export: densities at the points
// voxel_size * (i, j, k), in the blocks within three radii, where a Gaussian is 1e-4 of its peak.
// b0 is excluded, being unbounded.
class MediumSampling {
 public:
  // Finds the blocks; nullopt if there are more than `max_blocks`, each counted for every channel
  // of what is sampled, or if the lists of Gaussians per block need more memory than `max_blocks`
  // blocks. voxel_size > 0.
  static std::optional<MediumSampling> plan(const Medium& medium, double voxel_size,
                                            std::size_t max_blocks);

  [[nodiscard]] std::size_t blocks() const { return corners_.size(); }
  [[nodiscard]] std::uintmax_t bytes() const {
    return blocks() * channels(*medium_) * sizeof(DensityGrid::Block) +
           pairs_ * sizeof(std::uint32_t);
  }

  // In parallel, deterministic; nullopt if stopped. The medium must outlive this.
  [[nodiscard]] std::optional<DensityGrid> sample(
      const std::stop_token& stop = {}, const std::function<void(double)>& progress = {}) const;

  // Albedo and emission of the medium where it has matter, if a Gaussian has its own; on the blocks
  // of sample(). Albedo: scattering over extinction; emission: per unit of extinction optical
  // depth. `medium_albedo`: of Gaussians without their own. As sample() otherwise.
  [[nodiscard]] std::optional<VolumeColors> sample_colors(
      const glm::dvec3& medium_albedo, const std::stop_token& stop = {},
      const std::function<void(double)>& progress = {}) const;

 private:
  using Factor = std::function<double(const Gaussian&)>;
  // One for the density, three for an albedo and three for an emission.
  static std::size_t channels(const Medium& medium) {
    return 1 + (medium.has_albedos() ? 3 : 0) + (medium.has_emission() ? 3 : 0);
  }
  // Calls block_values(sums) for each block, with the sums of the Gaussians times `factors`.
  template <std::size_t count, class BlockValues>
  [[nodiscard]] std::optional<DensityGrid> sample(const std::array<Factor, count>& factors,
                                                  const std::stop_token& stop,
                                                  const std::function<void(double)>& progress,
                                                  BlockValues block_values) const;

  MediumSampling(const Medium& medium, double voxel_size)
      : medium_(&medium), voxel_size_(voxel_size) {}

  const Medium* medium_;
  double voxel_size_;
  std::vector<glm::ivec3> corners_;
  std::vector<std::vector<std::uint32_t>> gaussians_;  // per block
  std::size_t pairs_ = 0;                              // total
};

// The smallest voxel_size * 2^k that plan() accepts, rounded to two digits; nullopt if beyond 1e12.
std::optional<double> sufficient_voxel_size(const Medium& medium, double voxel_size,
                                            std::size_t max_blocks);

}  // namespace brume
