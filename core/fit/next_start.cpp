#include "core/fit/next_start.h"

#include <cmath>

#include "core/fit/fit_problem.h"

namespace brume {

std::vector<Gaussian> next_start(const DensityGrid& next, std::span<const Gaussian> gaussians,
                                 const VelocityGrid& velocity, double seconds) {
  FitProblem problem(next, shape_of(gaussians));
  std::vector<float> residuals(problem.size());
  const auto squares = [&](std::span<const Gaussian> moved) {
    problem.set(to_fit_gaussians(next, moved));
    return problem.residuals(residuals).all;
  };
  std::vector<Gaussian> best(gaussians.begin(), gaussians.end());
  double min_squares = squares(best);
  for (int halves = 0; halves <= 10; ++halves) {
    std::vector<Gaussian> moved =
        advected(gaussians, velocity, seconds * std::pow(0.5, 0.5 * halves));
    const double found = squares(moved);
    if (!(found < min_squares)) continue;
    min_squares = found;
    best = std::move(moved);
  }
  return best;
}

}  // namespace brume
