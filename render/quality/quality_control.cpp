#include "render/quality/quality_control.h"

#include <algorithm>

#include "render/quality/auto_quality.h"

namespace brume {
namespace {

// Before anything was measured: most scenes are rendered well by it, and soon.
constexpr std::size_t first_step = 2;

// Cheaper settings are tried where the error is below this share of the bound: the next step down
// has about twice the error.
constexpr double clearly_better = 0.4;

// Or far below it, where they have broken it in another view.
constexpr double far_better = 0.1;

QualityControl::Measures measures_of(const Scene& scene) {
  double depth = 0.0;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    depth += scene.medium.densities()[i] * scene.medium.radii()[i];
  }
  const auto lights =
      std::ranges::count(scene.lights, true, &Light::on) + (scene.environment ? 1 : 0);
  return {static_cast<double>(lights),
          static_cast<double>(scene.medium.size()),
          depth,
          scene.medium.homogeneous_density(),
          scene.optics.extent.value_or(0.0),
          scene.optics.noise.amplitude};
}

bool much_different(double a, double b) {
  return std::max(a, b) > 1.5 * std::min(a, b);
}

}  // namespace

QualityControl::QualityControl(const Settings& settings) : step_(first_step) {
  for (const Settings& step : quality_ladder(settings)) trials_.push_back({step, {}, false, 0.0});
}

void QualityControl::set_max_error(double max_error) {
  max_error_ = max_error;
  move();
}

void QualityControl::begin_frame(const Scene& scene, const Camera& camera) {
  if (camera != camera_) {
    camera_ = camera;
    for (Trial& trial : trials_) trial.in_other_view = true;
  }
  const Measures measures = measures_of(scene);
  if (measures_ && std::equal(measures.begin(), measures.end(), measures_->begin(),
                              [](double a, double b) { return !much_different(a, b); })) {
    return;
  }
  measures_ = measures;
  for (Trial& trial : trials_) trial.error.reset();
}

void QualityControl::reset() {
  measures_.reset();
  step_ = first_step;
  for (Trial& trial : trials_) trial.error.reset();
}

void QualityControl::record(const Settings& settings, const ErrorEstimate& error,
                            double milliseconds) {
  for (Trial& trial : trials_) {
    if (trial.settings == settings) trial = {settings, error, false, milliseconds};
  }
  move();
}

bool QualityControl::broke_bound(const Trial& trial) const {
  return trial.error && trial.error->high > max_error_;
}

bool QualityControl::may_go_down(double high) const {
  if (step_ == 0) return false;
  const Trial& next = trials_[step_ - 1];
  if (!broke_bound(next)) return high < clearly_better * max_error_;
  return next.in_other_view && high < far_better * max_error_;
}

// The next step up that has not broken the bound.
std::size_t QualityControl::finer_step() const {
  std::size_t step = step_ + 1;
  while (step < trials_.size() && broke_bound(trials_[step])) ++step;
  return step;
}

// Where none is certain to meet the bound: the cheapest that may meet it, or the finest.
// Finer settings would only be slower.
std::size_t QualityControl::step_to_settle() const {
  const auto cheapest =
      std::ranges::find_if(trials_, [this](const Trial& trial) { return may_keep_bound(trial); });
  if (cheapest == trials_.end()) return trials_.size() - 1;
  return static_cast<std::size_t>(cheapest - trials_.begin());
}

// Moves as far as known steps lead. It ends: up only to settings that have not broken the bound,
// down only to others, or to those that broke it in another view, which are then tried here.
void QualityControl::move() {
  while (const std::optional<ErrorEstimate>& error = trials_[step_].error) {
    if (broke_bound(trials_[step_])) {
      const std::size_t finer = finer_step();
      if (finer == trials_.size()) {
        step_ = step_to_settle();
        return;
      }
      step_ = finer;
    } else if (may_go_down(error->high)) {
      --step_;
      if (broke_bound(trials_[step_])) trials_[step_].error.reset();
    } else {
      return;
    }
  }
}

}  // namespace brume
