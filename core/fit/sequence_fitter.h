#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "brume/density_grid.h"
#include "brume/fit.h"
#include "core/fit/gaussian_numbers.h"
#include "core/volume/velocity_grid.h"

namespace brume {

// Fits one grid after another, each from the previous one's Gaussians.
class SequenceFitter {
 public:
  struct Next {
    Fit fit;
    std::size_t renewed = 0;  // Gaussians without a predecessor
  };
  // `velocity`: of the previous frame, over `seconds`, if known. `counter`: of the ids, which
  // several may share. nullopt when it was stopped.
  std::optional<Next> next(const DensityGrid& grid, const FitOptions& options,
                           const std::optional<VelocityGrid>& velocity, double seconds,
                           GaussianNumber& counter, const std::stop_token& stop,
                           const std::function<void(double)>& progress);

  // Whether the next fit starts from an earlier one, with as many Gaussians.
  [[nodiscard]] bool is_running() const { return !last_.empty(); }
  // Persistent ids of the last fit's Gaussians.
  [[nodiscard]] std::span<const GaussianNumber> ids() const { return numbers_.ids(); }

 private:
  std::vector<Gaussian> last_;
  GaussianNumbers numbers_;
};

}  // namespace brume
