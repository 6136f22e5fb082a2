#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/density_grid.h"
#include "brume/fit.h"
#include "core/fit/fit_gaussian.h"

namespace brume {

// The least-squares problem of fitting Gaussians to a density grid. Residuals, sum of Gaussians
// minus density: one per voxel of the grid's blocks and of adjacent empty blocks; and one of less
// weight at the center of each 2 x 2 x 2 voxels against their mean, since voxel-sized Gaussians
// could fit the voxels alone and miss the space between, which rays integrate as well. The Jacobian
// J is never stored: products with it are sums over pairs of Gaussian and block, where a ball is
// separable. Parallel and deterministic for any number of threads.
class FitProblem {
 public:
  // Steps of balls have no shape.
  FitProblem(const DensityGrid& grid, FitShape shape);

  // Number of residuals; the first half belongs to voxels.
  [[nodiscard]] std::size_t size() const { return targets_.size(); }
  // Sum of squared densities.
  [[nodiscard]] double sum_of_squares() const { return sum_of_squares_; }

  // Values of a grid with the same transform where the residuals are, times the roots of their
  // weights.
  [[nodiscard]] std::vector<float> sampled(const DensityGrid& grid) const;

  void set(std::span<const FitGaussian> gaussians);
  // The limits of Gaussians that the grid can hold.
  [[nodiscard]] static FitLimits limits(const DensityGrid& grid, FitShape shape);

  // Sets size() residuals; returns the sum of their squares.
  struct Squares {
    double all = 0.0;
    double voxels = 0.0;
  };
  Squares residuals(std::span<float> residuals) const;
  // result[residual] = J step.
  void apply(std::span<const FitStep> step, std::span<float> result) const;
  // result[gaussian] = J^T weights.
  void apply_transposed(std::span<const float> weights, std::span<FitStep> result) const;
  // Calls visit(center in grid axes [u], sum of values) for cubes of side^3 voxels, side 2 or 4, in
  // a fixed order.
  template <class Visit>
  void each_cube(int side, std::span<const float> values, Visit visit) const {
    constexpr int all = DensityGrid::side;
    for (std::size_t block = 0; block < corners_.blocks.size(); ++block) {
      const float* block_values = values.data() + block * DensityGrid::block_size;
      for (int x = 0; x < all; x += side) {
        for (int y = 0; y < all; y += side) {
          for (int z = 0; z < all; z += side) {
            double sum = 0.0;
            for (int i = 0; i < side * side * side; ++i) {
              const int dx = x + i / (side * side);
              const int dy = y + i / side % side;
              sum += static_cast<double>(block_values[(dx * all + dy) * all + z + i % side]);
            }
            const glm::dvec3 center = glm::dvec3(x, y, z) + 0.5 * (side - 1);
            visit(spacing_ * (glm::dvec3(corners_.blocks[block].corner) + center), sum);
          }
        }
      }
    }
  }

 private:
  // Whether a Gaussian may touch the block of voxels with this minimum corner [u], or that of the
  // centers beside it.
  [[nodiscard]] bool reaches(const FitGaussian& gaussian, const glm::dvec3& first) const;
  // Calls visit(block) for the blocks that a Gaussian touches.
  template <class Visit>
  void each_block(const FitGaussian& gaussian, Visit visit) const;

  // A block of residuals: of voxels, or of the centers between them.
  struct Block {
    glm::dvec3 first;  // minimum corner [u]
    float weight;      // square root of the weight
  };

  FitShape shape_;
  glm::dvec3 spacing_;
  DensityGrid corners_;        // voxel blocks; values unused
  std::vector<Block> blocks_;  // of voxels, then of centers, both in the order of corners_
  std::vector<float> targets_;
  double sum_of_squares_ = 0.0;
  std::vector<FitGaussian> gaussians_;
  // Blocks per Gaussian and Gaussians per block, in compressed rows.
  std::vector<std::size_t> block_offsets_;
  std::vector<std::uint32_t> blocks_of_;
  std::vector<std::size_t> gaussian_offsets_;
  std::vector<std::uint32_t> gaussians_of_;
};

}  // namespace brume
