#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

namespace brume {

// Anderson acceleration of a fixed-point iteration x <- F(x) (Walker and Ni, "Anderson Acceleration
// for Fixed-Point Iterations", SIAM J. Numer. Anal. 2011): the next x is the combination of the
// last iterations whose residual F(x) - x is smallest. Sums run in a fixed order.
class AndersonAcceleration {
 public:
  // How many earlier iterations are combined.
  static constexpr std::size_t depth = 4;

  // Squares of residuals weight elements k * weights.size() + i by weights[i]. Keeps a reference to
  // them.
  explicit AndersonAcceleration(std::span<const float> weights) : weights_(weights) {}

  // From x and fx = F(x), of the same size in all calls: replaces x by the next one.
  void advance(std::span<float> x, std::span<const float> fx);

 private:
  [[nodiscard]] double dot(std::span<const float> a, std::span<const float> b) const;

  std::span<const float> weights_;
  std::vector<float> last_residual_, last_fx_;
  // Differences between successive iterations.
  std::deque<std::vector<float>> residual_changes_, fx_changes_;
};

}  // namespace brume
