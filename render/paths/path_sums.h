#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render/paths/path_random.h"

namespace brume {

// Sums of a pixel's samples, in order, so that it does not matter in how many pieces they came.
class PathSums {
 public:
  // Sample k = 0, 1, ... `channels`: 1 for those that count for the noise, else 0.
  void add(int k, const glm::dvec3& sample, const glm::dvec3& channels) {
    sum_ += sample;
    squares_ += glm::dot(channels * sample, sample);
    block_ += sample;
    if (k % path_block != path_block - 1) return;
    block_squares_ += glm::dot(channels * block_, block_);
    block_ = glm::dvec3(0.0);
  }

  // Mean of n samples.
  [[nodiscard]] glm::dvec3 mean(int n) const { return sum_ / static_cast<double>(n); }

  // Variance of the mean of n samples, summed over the channels: by the scatter of blocks, or, if
  // there are too few, of samples, which leaves out what stratification gains. 0 for one sample.
  [[nodiscard]] double variance(int n, const glm::dvec3& channels) const {
    const int blocks = n / path_block;
    if (blocks >= 2) {
      const double full = static_cast<double>(blocks) * path_block;
      const double scatter = variance_of_sum(blocks, sum_ - block_, block_squares_, channels);
      return scatter / (full * n);
    }
    if (n < 2) return 0.0;
    return variance_of_sum(n, sum_, squares_, channels) / (static_cast<double>(n) * n);
  }

 private:
  // The variance of a sum of n independent terms, by their squares.
  static double variance_of_sum(int n, const glm::dvec3& sum, double squares,
                                const glm::dvec3& channels) {
    const double mean_square = glm::dot(channels * sum, sum) / n;
    return std::max(0.0, squares - mean_square) * n / (n - 1.0);
  }

  glm::dvec3 sum_{0.0};
  glm::dvec3 block_{0.0};       // of the block that is not complete
  double squares_ = 0.0;        // of samples
  double block_squares_ = 0.0;  // of sums of complete blocks
};

}  // namespace brume
