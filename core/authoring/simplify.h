#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "brume/medium.h"

namespace brume {

// Optical depth of the lines through Gaussians along three axes, at the resolution of a 128th of
// their bounds.
class AxisDepths {
 public:
  explicit AxisDepths(const Medium& medium);

  // One more of them, or less. Outside of the bounds of the first ones it counts at their border.
  void add(const Gaussian& gaussian) { add(gaussian, 1.0); }
  void remove(const Gaussian& gaussian) { add(gaussian, -1.0); }

  // The depth of the shallowest of the three lines through a point; outside of the bounds, of the
  // nearest.
  [[nodiscard]] double least(const glm::dvec3& x) const;

 private:
  [[nodiscard]] glm::ivec3 cell_of(const glm::dvec3& x) const;
  void add(const Gaussian& gaussian, double times);

  glm::dvec3 low_{0.0}, size_{1.0};
  std::array<std::vector<double>, 3> depths_;
};

// Fewer Gaussians in place of many.
struct Simplified {
  std::vector<std::uint32_t> kept;  // indices of those that stay as they are
  std::vector<Gaussian> merged;     // in place of the others
  // The others' indices: of each of `merged` what it stands for, up to its end.
  std::vector<std::uint32_t> members;
  std::vector<std::uint32_t> member_ends;
  // Estimate of the relative rms error of optical depth that light sees: where lines are deeper
  // than 1, of the first unit.
  double error = 0.0;

  [[nodiscard]] std::span<const std::uint32_t> members_of(std::size_t k) const {
    const std::uint32_t first = k > 0 ? member_ends[k - 1] : 0;
    return std::span(members).subspan(first, member_ends[k] - first);
  }
  // All that are left.
  [[nodiscard]] std::vector<Gaussian> of(const Medium& medium) const;
};

struct SimplifyLimits {
  double max_error = 0.0;      // in (0, 1]
  bool across_groups = false;  // what is merged of several is in none
  bool ellipsoids = false;     // what is merged may be ellipsoids, else it is balls
};

// Merges neighbouring Gaussians of equal optics, and of one group: two become one of the same mass,
// mean and covariance, or as a ball of the same mean variance. The error that each merge adds is
// known in closed form (the squared difference of the lines' optical depths, integrated over all
// lines), and merges go on where the sum of errors on a line stays within max_error of its depth:
// many small Gaussians that overlap become few, one that stands alone stays. O(n log n), in
// parallel; the result is the same whatever the threads. nullopt: stopped.
std::optional<Simplified> simplify(const Medium& medium, const SimplifyLimits& limits,
                                   const std::stop_token& stop = {},
                                   const std::function<void(double)>& progress = {});

// The same for some of many Gaussians, whose depths these are.
std::optional<Simplified> simplify(const Medium& medium, const SimplifyLimits& limits,
                                   const AxisDepths& depths, const std::stop_token& stop = {},
                                   const std::function<void(double)>& progress = {});

// The share of the Gaussians that simplify() would leave, from samples of them: to a tenth or so.
double estimated_share(const Medium& medium, const SimplifyLimits& limits,
                       const AxisDepths& depths);

}  // namespace brume
