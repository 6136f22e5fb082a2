#include "core/fit/optics_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "brume/limits.h"
#include "core/fit/fit_problem.h"
#include "core/fit/sufficient_grid.h"

namespace brume {
namespace {

using Factors = std::vector<double>;

// Sums of Gaussians times a factor each, fitted to grids.
class FactorFit {
 public:
  FactorFit(const DensityGrid& density, std::span<const Gaussian> gaussians)
      : problem_(density, shape_of(gaussians)), count_(gaussians.size()), sums_(problem_.size()) {
    problem_.set(to_fit_gaussians(density, gaussians));
  }

  // Nonnegative least squares by multiplicative updates (ISRA, Daube-Witherspoon and Muehllehner
  // 1986). The first gives means weighted by density, the others a tenth of their errors; more
  // updates gain little. A target times k gives factors times k.
  Factors fit(const DensityGrid& target) { return improved(Factors(count_, 1.0), target, 20); }
  // From a start, by so many updates.
  Factors improved(Factors factors, const DensityGrid& target, int updates) {
    const Factors wanted = gathered(problem_.sampled(target));
    for (int i = 0; i < updates; ++i) {
      add_up(factors);
      const Factors found = gathered(sums_);
      for (std::size_t k = 0; k < count_; ++k) {
        if (found[k] > 0.0) factors[k] *= wanted[k] / found[k];
      }
    }
    return factors;
  }

  struct Squares {
    double differences = 0.0;
    double target = 0.0;

    void operator+=(const Squares& other) {
      differences += other.differences;
      target += other.target;
    }
    [[nodiscard]] double error() const {
      return target > 0.0 ? std::sqrt(differences / target) : 0.0;
    }
  };
  // Over voxels.
  Squares squares(const DensityGrid& target, const Factors& factors) {
    add_up(factors);
    const std::vector<float> wanted = problem_.sampled(target);
    Squares squares;
    for (std::size_t i = 0; i < wanted.size() / 2; ++i) {
      const auto value = static_cast<double>(wanted[i]);
      const double difference = static_cast<double>(sums_[i]) - value;
      squares += {difference * difference, value * value};
    }
    return squares;
  }

 private:
  void add_up(const Factors& factors) {
    std::vector<FitStep> steps(count_, FitStep{});
    for (std::size_t k = 0; k < count_; ++k) steps[k][3] = factors[k];
    problem_.apply(steps, sums_);
  }
  // Each Gaussian's sum over residuals.
  [[nodiscard]] Factors gathered(std::span<const float> values) const {
    std::vector<FitStep> sums(count_);
    problem_.apply_transposed(values, sums);
    Factors result;
    for (const FitStep& sum : sums) result.push_back(sum[3]);
    return result;
  }

  FitProblem problem_;
  std::size_t count_;
  std::vector<float> sums_;
};

// The same at a resolution that suffices for the Gaussians, and last at the grid's own.
class RefinedFactorFit {
 public:
  RefinedFactorFit(const DensityGrid& density, std::span<const Gaussian> gaussians)
      : fine_(density, gaussians), coarse_grid_(sufficient_grid(density, gaussians.size())) {
    if (coarse_grid_) coarse_.emplace(*coarse_grid_, gaussians);
  }

  Factors fit(const DensityGrid& target) {
    constexpr int final_updates = 2;
    if (!coarse_) return fine_.fit(target);
    assert(target.spacing.x < coarse_grid_->spacing.x);  // by a power of 2
    DensityGrid less = coarser(target);
    while (less.spacing.x < coarse_grid_->spacing.x) less = coarser(less);
    return fine_.improved(coarse_->fit(less), target, final_updates);
  }

  FactorFit::Squares squares(const DensityGrid& target, const Factors& factors) {
    return fine_.squares(target, factors);
  }

 private:
  FactorFit fine_;
  std::optional<DensityGrid> coarse_grid_;
  std::optional<FactorFit> coarse_;
};

}  // namespace

OpticsErrors fit_optics(const DensityGrid& density, const OpticsTargets& targets,
                        std::span<Gaussian> gaussians) {
  OpticsErrors errors;
  if (gaussians.empty() || (!targets.extinction && !targets.emission)) return errors;
  RefinedFactorFit fit(density, gaussians);
  // Relative to the same fit of the density, so that what is the same everywhere stays so.
  const Factors densities = fit.fit(density);
  FactorFit::Squares extinction_squares;
  FactorFit::Squares emission_squares;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto c = static_cast<int>(channel);
    Factors extinctions(gaussians.size(), 1.0);  // over densities
    if (targets.extinction) {
      const DensityGrid& target = (*targets.extinction)[channel];
      const Factors found = fit.fit(target);
      for (std::size_t k = 0; k < gaussians.size(); ++k) {
        const double albedo = found[k] > 0.0 ? densities[k] / found[k] : 1.0;
        auto& own_albedo = gaussians[k].optics.albedo;
        if (!own_albedo) own_albedo.emplace(1.0);
        (*own_albedo)[c] = std::clamp(albedo, min_fitted_albedo, 1.0);
        extinctions[k] = 1.0 / (*own_albedo)[c];
      }
      extinction_squares += fit.squares(target, extinctions);
    }
    if (targets.emission) {
      const DensityGrid& target = (*targets.emission)[channel];
      const Factors found = fit.fit(target);
      Factors emitted(gaussians.size());
      for (std::size_t k = 0; k < gaussians.size(); ++k) {
        const double emission =
            densities[k] > 0.0
                ? std::min(found[k] / (densities[k] * extinctions[k]), limits::intensity)
                : 0.0;
        gaussians[k].optics.emission[c] = emission;
        emitted[k] = emission * extinctions[k];
      }
      emission_squares += fit.squares(target, emitted);
    }
  }
  if (targets.extinction) errors.extinction = extinction_squares.error();
  if (targets.emission) errors.emission = emission_squares.error();
  return errors;
}

}  // namespace brume
