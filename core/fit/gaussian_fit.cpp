#include "brume/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "core/fit/fit_problem.h"
#include "core/fit/fit_start.h"
#include "core/fit/sufficient_grid.h"

namespace brume {
namespace {

using Steps = std::vector<FitStep>;

double dot(const Steps& a, const Steps& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].size(); ++k) sum += a[i][k] * b[i][k];
  }
  return sum;
}

// a += s b
void add(Steps& a, double s, const Steps& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].size(); ++k) a[i][k] += s * b[i][k];
  }
}

class Fitting {
 public:
  Fitting(const DensityGrid& grid, FitShape shape, const std::stop_token& stop,
          const std::function<void(double)>& progress)
      : grid_(grid),
        shape_(shape),
        problem_(grid, shape),
        stop_(stop),
        progress_(progress),
        limits_(FitProblem::limits(grid, shape)) {
    residuals_.resize(problem_.size());
    trial_residuals_.resize(problem_.size());
    along_.resize(problem_.size());
  }

  void begin(std::vector<FitGaussian> gaussians) {
    gaussians_ = std::move(gaussians);
    renewed_.assign(gaussians_.size(), false);
    evaluate();
    damping_ = 1e-2;
    relocated_fraction_ = 0.1;
  }

  [[nodiscard]] double error() const {
    return std::sqrt(squares_.voxels / std::max(problem_.sum_of_squares(), 1e-300));
  }

  // Up to `steps` steps, ending early where one no longer takes the share `min_gain` of the
  // squares. False when stopped.
  bool descend(int steps, double target_error, double progress_begin, double progress_end,
               double min_gain = 1e-4) {
    for (int i = 0; i < steps; ++i) {
      if (stop_.stop_requested()) return false;
      if (progress_) progress_(progress_begin + (progress_end - progress_begin) * i / steps);
      const double squares_before = squares_.all;
      if (error() <= target_error) break;
      if (!step()) break;
      if (squares_.all > (1.0 - min_gain) * squares_before) break;
    }
    return !stop_.stop_requested();
  }

  // Descends, and relocates before each round of steps but the first. False if stopped.
  bool fit(int rounds, int steps, double target_error, double progress_begin, double progress_end) {
    const double share = (progress_end - progress_begin) / rounds;
    for (int round = 0; round < rounds; ++round) {
      const double begin = progress_begin + round * share;
      if (!(round == 0 ? descend(steps, target_error, begin, begin + share)
                       : relocate_and_descend(steps, target_error, begin, begin + share))) {
        return false;
      }
      if (error() <= target_error) break;
    }
    return true;
  }

  void scale_integral() {
    double integral = 0.0;
    for (const FitGaussian& g : gaussians_) integral += g.integral();
    if (!(integral > 0.0)) return;
    const double factor = grid_.integral() / integral;
    for (FitGaussian& g : gaussians_) g.c *= factor;
    evaluate();
  }

  [[nodiscard]] Fit result() const {
    Fit fit;
    fit.density_error = error();
    fit.products = products_;
    for (const FitGaussian& g : gaussians_) fit.gaussians.push_back(to_gaussian(grid_, g));
    return fit;
  }
  [[nodiscard]] const std::vector<bool>& renewed() const { return renewed_; }

 private:
  // Moves the least useful Gaussians to where the residual is largest and optimizes again. If that
  // is no better, reverts and moves fewer next time. False if stopped.
  bool relocate_and_descend(int steps, double target_error, double progress_begin,
                            double progress_end) {
    const std::vector<FitGaussian> gaussians = gaussians_;
    const std::vector<bool> renewed = renewed_;
    const double squares = squares_.all;
    relocate();
    if (!descend(steps, target_error, progress_begin, progress_end)) return false;
    if (squares_.all < squares) return true;
    gaussians_ = gaussians;
    renewed_ = renewed;
    evaluate();
    relocated_fraction_ *= 0.3;
    return descend(steps, target_error, progress_begin, progress_end);
  }

  void evaluate() { squares_ = evaluate(residuals_); }
  // After gaussians_ have changed; within limits from then on.
  FitProblem::Squares evaluate(std::span<float> residuals) {
    narrow_.resize(gaussians_.size());
    for (std::size_t i = 0; i < narrow_.size(); ++i) narrow_[i] = limit(gaussians_[i], limits_);
    problem_.set(gaussians_);
    return problem_.residuals(residuals);
  }
  void relocate();
  // The integral of a Gaussian's square over the volume of a voxel.
  [[nodiscard]] double own_square(const FitGaussian& g) const {
    return g.c * g.c * std::pow(std::numbers::pi / 2.0, 1.5) /
           (g.a * g.a * g.a * grid_.voxel_volume());
  }
  // One accepted step; false if none helps.
  bool step();
  Steps solve(const Steps& gradient, std::span<const double> weights);
  // Sets to 0 what `held_` says.
  void hold(Steps& steps) const;

  const DensityGrid& grid_;
  FitShape shape_;
  FitProblem problem_;
  std::stop_token stop_;
  const std::function<void(double)>& progress_;
  FitLimits limits_;
  double damping_;
  double relocated_fraction_;  // fraction of Gaussians that may be moved
  std::size_t products_ = 0;
  FitProblem::Squares squares_;
  std::vector<FitGaussian> gaussians_;
  std::vector<std::array<bool, 3>> narrow_;  // see limit()
  // Axes of ellipsoids that are as narrow as they may be, and would become narrower by a step.
  std::vector<std::array<bool, 3>> held_;
  std::vector<bool> renewed_;
  std::vector<float> residuals_, trial_residuals_, along_;
};

// The part of J^T J that belongs to one Gaussian alone, for many voxels per radius: with
// w = integral of g^2, it is w for m db and off the diagonal of dm m^-1. For log c and log a it is
// w ((1, -3/2), (-3/2, 15/4)); for log c and the diagonal, w times 1, -1/2 between them, and 3/4
// and 1/4 within the diagonal. This is its diagonal over w.
double own_diagonal(std::size_t k, FitShape shape) {
  if (shape == FitShape::ball) return k == 4 ? 3.75 : 1.0;
  return k >= 4 && k < 7 ? 0.75 : 1.0;
}

// The solution of (that, with `damping` of its diagonal added) x = r.
FitStep solve_own(const FitStep& r, double w, double damping, FitShape shape) {
  const double damped = 1.0 + damping;
  FitStep x;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = r[k] / (w * damped);
  if (shape == FitShape::ball) {
    const double determinant = 3.75 * damped * damped - 2.25;
    x[3] = (3.75 * damped * r[3] + 1.5 * r[4]) / (w * determinant);
    x[4] = (damped * r[4] + 1.5 * r[3]) / (w * determinant);
    return x;
  }
  // The diagonal by its mean and what differs from it.
  const double mean = (r[4] + r[5] + r[6]) / 3.0;
  const double within = 0.75 * damped + 0.5;
  const double determinant = within * damped - 0.75;
  x[3] = (within * r[3] + 1.5 * mean) / (w * determinant);
  const double change = (damped * mean + 0.5 * r[3]) / (w * determinant);
  for (std::size_t k = 4; k < 7; ++k) {
    x[k] = change + (r[k] - mean) / (w * (0.75 * damped - 0.25));
  }
  return x;
}

// (J^T J + damping D) x = -gradient by preconditioned conjugate gradients.
Steps Fitting::solve(const Steps& gradient, std::span<const double> weights) {
  // The model holds only nearby: a more exact solution wins less than another step.
  constexpr int max_iterations = 8;
  constexpr double enough = 0.1;  // of the gradient
  const std::size_t n = gradient.size();
  Steps x(n, FitStep{});
  Steps r = gradient;
  for (FitStep& s : r) {
    for (double& v : s) v = -v;
  }
  hold(r);
  Steps z(n);
  const auto precondition = [&] {
    for (std::size_t i = 0; i < n; ++i) z[i] = solve_own(r[i], weights[i], damping_, shape_);
    hold(z);
  };
  precondition();
  Steps p = z;
  Steps q(n);
  double rz = dot(r, z);
  const double first = rz;
  for (int k = 0; k < max_iterations && rz > enough * enough * first; ++k) {
    problem_.apply(p, along_);
    problem_.apply_transposed(along_, q);
    products_ += 2;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t c = 0; c < q[i].size(); ++c) {
        q[i][c] += damping_ * own_diagonal(c, shape_) * weights[i] * p[i][c];
      }
    }
    hold(q);
    const double curvature = dot(p, q);
    if (!(curvature > 0.0)) break;
    const double length = rz / curvature;
    add(x, length, p);
    add(r, -length, q);
    precondition();
    const double next = dot(r, z);
    const double keep = next / rz;
    rz = next;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t c = 0; c < p[i].size(); ++c) p[i][c] = z[i][c] + keep * p[i][c];
    }
  }
  return x;
}

void Fitting::hold(Steps& steps) const {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (held_[i][k]) steps[i][4 + k] = 0.0;
    }
  }
}

bool Fitting::step() {
  const std::size_t n = gaussians_.size();
  Steps gradient(n);
  problem_.apply_transposed(residuals_, gradient);
  ++products_;
  std::vector<double> weights(n);
  for (std::size_t i = 0; i < n; ++i) weights[i] = own_square(gaussians_[i]);
  held_.resize(shape_ == FitShape::ellipsoid ? n : 0);
  for (std::size_t i = 0; i < held_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) held_[i][k] = narrow_[i][k] && gradient[i][4 + k] < 0.0;
  }
  // A Gaussian that is almost nothing has no weight to hold it.
  const double min_weight =
      1e-6 * std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(n);
  for (double& w : weights) w = std::max(w, min_weight);

  const std::vector<FitGaussian> previous = gaussians_;
  const double squares_before = squares_.all;
  for (int attempt = 0; attempt < 6; ++attempt) {
    const Steps change = solve(gradient, weights);
    for (std::size_t i = 0; i < n; ++i) gaussians_[i] = moved(previous[i], change[i], shape_);
    squares_ = evaluate(trial_residuals_);
    if (squares_.all < squares_before) {
      std::swap(residuals_, trial_residuals_);
      damping_ = std::max(0.3 * damping_, 1e-5);
      return true;
    }
    damping_ = std::max(10.0 * damping_, 1e-3);
  }
  gaussians_ = previous;
  evaluate();
  return false;
}

void Fitting::relocate() {
  // A Gaussian's neighbours make up for most of its loss.
  constexpr double lost = 0.3;
  const std::size_t n = gaussians_.size();
  const auto max_relocated = static_cast<std::size_t>(relocated_fraction_ * static_cast<double>(n));
  // The worth of a Gaussian: about what the squares would grow by without it, by its own gradient.
  Steps gradient(n);
  problem_.apply_transposed(residuals_, gradient);
  ++products_;
  std::vector<std::pair<double, std::size_t>> worth;
  for (std::size_t i = 0; i < n; ++i) {
    worth.emplace_back(own_square(gaussians_[i]) - 2.0 * gradient[i][3], i);
  }
  std::ranges::sort(worth);

  // Cubes of voxels with the largest residual: a Gaussian there reduces the objective by about
  // this.
  struct Place {
    double gain;
    FitGaussian gaussian;
  };
  std::vector<Place> places;
  for (const int edge : {2, 4}) {
    problem_.each_cube(edge, residuals_, [&](const glm::dvec3& center, double sum) {
      if (!(sum < 0.0)) return;
      const double variance = edge * edge / 12.0 * glm::dot(grid_.spacing, grid_.spacing) / 3.0;
      FitGaussian g;
      g.b = center;
      g.a = 1.0 / std::max(std::sqrt(2.0 * variance), limits_.min_radius);
      g.c = -sum * grid_.voxel_volume() * std::pow(g.a, 3.0) / std::pow(std::numbers::pi, 1.5);
      places.push_back({sum * sum / (edge * edge * edge), g});
    });
  }
  std::ranges::stable_sort(places, std::greater(), &Place::gain);
  // One Gaussian at first makes up for what a cube of 4 lacks.
  std::set<std::tuple<int, int, int>> cubes;
  std::size_t k = 0;
  for (const Place& place : places) {
    if (k == max_relocated || place.gain < lost * worth[k].first) break;
    const glm::ivec3 cube(glm::floor(0.25 * (place.gaussian.b / grid_.spacing + 0.5)));
    if (!cubes.emplace(cube.x, cube.y, cube.z).second) continue;
    gaussians_[worth[k].second] = place.gaussian;
    renewed_[worth[k].second] = true;
    ++k;
  }
  evaluate();
}

// Fits `count` Gaussians from a start of its own. False if stopped.
bool fit_anew(Fitting& fitting, const DensityGrid& grid, std::size_t count,
              const FitOptions& options, const std::stop_token& stop, double progress_begin,
              double progress_end) {
  std::vector<FitGaussian> start = split_into_gaussians(grid, count, options.shape, stop);
  if (stop.stop_requested()) return false;
  fitting.begin(std::move(start));
  return fitting.fit(4, 15, options.max_error, progress_begin, progress_end);
}

}  // namespace

std::optional<Fit> fit_gaussians(const DensityGrid& grid, const FitOptions& options,
                                 const std::stop_token& stop,
                                 const std::function<void(double)>& progress) {
  Fitting fitting(grid, options.shape, stop, progress);
  const auto fit = [&](std::size_t count, double progress_begin, double progress_end) {
    const std::optional<DensityGrid> coarse = sufficient_grid(grid, count);
    if (!coarse) {
      return fit_anew(fitting, grid, count, options, stop, progress_begin, progress_end);
    }
    // The steps before were cheaper.
    constexpr int final_steps = 3;
    constexpr double min_gain = 0.02;
    const double middle = 0.5 * (progress_begin + progress_end);
    Fitting first(*coarse, options.shape, stop, progress);
    if (!fit_anew(first, *coarse, count, options, stop, progress_begin, middle)) return false;
    fitting.begin(to_fit_gaussians(grid, first.result().gaussians));
    if (fitting.error() <= 1.1 * first.error()) return true;
    return fitting.descend(final_steps, options.max_error, middle, progress_end, min_gain);
  };
  if (!(options.max_error > 0.0)) {
    if (!fit(options.count, 0.0, 1.0)) return std::nullopt;
  } else {
    // Twice as many each time: in all no more than twice the work of the last.
    for (std::size_t count = std::min<std::size_t>(options.count, 32);;
         count = std::min(2 * count, options.count)) {
      const double fraction = static_cast<double>(count) / static_cast<double>(options.count);
      if (!fit(count, 0.5 * fraction, fraction)) return std::nullopt;
      if (fitting.error() <= options.max_error || count == options.count) break;
    }
  }
  fitting.scale_integral();
  return fitting.result();
}

std::optional<Fit> fit_preview(const DensityGrid& grid, const FitOptions& options,
                               const std::stop_token& stop) {
  constexpr int steps = 3;
  const std::function<void(double)> no_progress;
  Fitting fitting(grid, options.shape, stop, no_progress);
  fitting.begin(split_into_gaussians(grid, options.count, options.shape, stop));
  if (!fitting.descend(steps, options.max_error, 0.0, 1.0)) return std::nullopt;
  fitting.scale_integral();
  return fitting.result();
}

std::optional<Refit> refit_gaussians(const DensityGrid& grid, std::span<const Gaussian> start,
                                     const std::stop_token& stop,
                                     const std::function<void(double)>& progress) {
  Fitting fitting(grid, shape_of(start), stop, progress);
  fitting.begin(to_fit_gaussians(grid, start));
  if (!fitting.fit(6, 5, 0.0, 0.0, 1.0)) return std::nullopt;
  fitting.scale_integral();
  return Refit{fitting.result(), fitting.renewed()};
}

}  // namespace brume
