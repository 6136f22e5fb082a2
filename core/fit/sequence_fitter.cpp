#include "core/fit/sequence_fitter.h"

#include <utility>

#include "core/fit/next_start.h"

namespace brume {

std::optional<SequenceFitter::Next> SequenceFitter::next(
    const DensityGrid& grid, const FitOptions& options, const std::optional<VelocityGrid>& velocity,
    double seconds, GaussianNumber& counter, const std::stop_token& stop,
    const std::function<void(double)>& progress) {
  Next next;
  if (last_.empty() || grid.blocks.empty()) {
    auto fit = fit_gaussians(grid, options, stop, progress);
    if (!fit) return std::nullopt;
    next.fit = std::move(*fit);
    numbers_.begin(next.fit.gaussians.size(), counter);
  } else {
    if (velocity) last_ = next_start(grid, last_, *velocity, seconds);
    auto refit = refit_gaussians(grid, last_, stop, progress);
    if (!refit) return std::nullopt;
    next.fit = std::move(refit->fit);
    next.renewed = numbers_.relocate(refit->renewed, counter);
  }
  last_ = next.fit.gaussians;
  return next;
}

}  // namespace brume
