#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tools/bench/measure/measurement.h"

namespace brume {

// The settings that no other one beats in both CPU time and error, from cheap to costly: indices.
std::vector<std::size_t> frontier(std::span<const Measurement> settings);

// The cheapest setting (CPU time) whose error, by the upper end of its interval, is at most
// `error`: an index.
std::optional<std::size_t> cheapest_within(std::span<const Measurement> settings, double error);

// One point of a cost curve.
struct CostPoint {
  double size = 0.0;              // Gaussians, lights, pixels, slices
  double cpu_milliseconds = 0.0;  // > 0
};

// Exponent p of cost ~ size^p by least squares of logarithms; at least two sizes.
double fitted_exponent(std::span<const CostPoint> points);

}  // namespace brume
