#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "render/error_estimate.h"

namespace brume {

// Errors against a truth that is itself known by Monte Carlo only.

// Something at each of many points, RGB, as so many runs of Monte Carlo have it: independent of
// each other and right on average.
inline constexpr std::size_t independent_runs = 8;
using Runs = std::array<std::vector<glm::dvec3>, independent_runs>;

// rms(differences) over rms(values), without the noise of the runs: a square is the product of two
// different runs, averaged over all pairs of them, so that noise is 0 on average. The interval is
// that of 95% of the jackknife over runs. At least one point; 0 where noise hides all.
ErrorEstimate unbiased_error(const Runs& differences, const Runs& values);

}  // namespace brume
