#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/quality/error_estimate.h"

namespace brume {

// Errors against a truth that is itself known by Monte Carlo only.

// Something at each of many points, RGB, as so many runs of Monte Carlo have it: independent of
// each other and right on average.
inline constexpr std::size_t independent_runs = 8;
using Runs = std::array<std::vector<glm::dvec3>, independent_runs>;

// rms(differences) over rms(values), free of the runs' noise: squares are products of two different
// runs, averaged over all pairs, so noise averages to 0. The interval is 95% by jackknife over
// runs. At least one point; 0 if noise dominates.
ErrorEstimate unbiased_error(const Runs& differences, const Runs& values);

// The error of a method compared with that of another.
struct ComparedError {
  std::string label;
  ErrorEstimate error;
  std::optional<ErrorEstimate> other;
};

}  // namespace brume
