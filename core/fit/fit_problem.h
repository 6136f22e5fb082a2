#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/medium/gaussian.h"
#include "core/volume/density_grid.h"

namespace brume {

// A Gaussian c exp(-a^2 |p - b|^2) in the grid's own axes, p = spacing * voxel [u].
struct FitGaussian {
  glm::dvec3 b{0.0};
  double a = 1.0;  // [1/u]
  double c = 0.0;  // [1/u], > 0

  [[nodiscard]] double mass() const;  // [u^2]
};

// Gaussians of the world in a grid's own axes.
std::vector<FitGaussian> to_fit_gaussians(const DensityGrid& grid,
                                          std::span<const Gaussian> gaussians);

// A change of one Gaussian, without unit: a db (three numbers), d log a, d log c.
using FitStep = std::array<double, 5>;

// The least-squares problem of Gaussians that are to make a density grid: a residual, sum of
// Gaussians minus density, for each voxel of the grid's blocks and the empty ones around them, so
// that what spills over counts; and one more, of less weight, in the middle of each eight voxels,
// where the density is their mean: with the voxels alone, Gaussians as small as a voxel fit their
// values and miss what is between them, which rays meet as much. The matrix J of its derivatives is
// never stored: products with it are sums over pairs of a Gaussian and a block it reaches, where
// the Gaussian is a product of three short vectors. All in parallel; results do not depend on the
// number of threads.
class FitProblem {
 public:
  explicit FitProblem(const DensityGrid& grid);

  // Of residuals; the first half are the voxels'.
  [[nodiscard]] std::size_t size() const { return targets_.size(); }
  // Of the voxels' densities.
  [[nodiscard]] double sum_of_squares() const { return sum_of_squares_; }

  // From here on, of these Gaussians. Their a times the spacing is at most `sharpest`.
  void set(std::span<const FitGaussian> gaussians);
  static constexpr double sharpest = 1.4;

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
  // Calls visit(middle in the grid's axes [u], sum of the values) for cubes of side^3 voxels, 2 or
  // 4, in a fixed order.
  template <class Visit>
  void each_cube(int side, std::span<const float> values, Visit visit) const {
    constexpr int all = DensityGrid::side;
    for (std::size_t block = 0; block < corners_.blocks.size(); ++block) {
      const float* own = values.data() + block * DensityGrid::block_size;
      for (int x = 0; x < all; x += side) {
        for (int y = 0; y < all; y += side) {
          for (int z = 0; z < all; z += side) {
            double sum = 0.0;
            for (int i = 0; i < side * side * side; ++i) {
              const int dx = x + i / (side * side);
              const int dy = y + i / side % side;
              sum += static_cast<double>(own[(dx * all + dy) * all + z + i % side]);
            }
            const glm::dvec3 middle = glm::dvec3(x, y, z) + 0.5 * (side - 1);
            visit(spacing_ * (glm::dvec3(corners_.blocks[block].corner) + middle), sum);
          }
        }
      }
    }
  }

 private:
  // Calls visit(block) for the blocks that a Gaussian reaches.
  template <class Visit>
  void each_block(const FitGaussian& gaussian, Visit visit) const;

  // A block of residuals: of voxels, or of the middles between them.
  struct Block {
    glm::dvec3 first;  // its least point [u]
    float weight;      // root of the residuals' weight
  };

  glm::dvec3 spacing_;
  DensityGrid corners_;        // of the blocks of voxels; their values are not used
  std::vector<Block> blocks_;  // of voxels, then of middles, both in the order of corners_
  std::vector<float> targets_;
  double sum_of_squares_ = 0.0;
  std::vector<FitGaussian> gaussians_;
  // Blocks of each Gaussian and Gaussians of each block, as arrays with offsets.
  std::vector<std::size_t> block_offsets_;
  std::vector<std::uint32_t> blocks_of_;
  std::vector<std::size_t> gaussian_offsets_;
  std::vector<std::uint32_t> gaussians_of_;
};

}  // namespace brume
