#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/quality/error_estimate.h"
#include "render/settings.h"

namespace brume {

// `auto` for interactive rendering: renders with the current choice, measures the frame when idle,
// and moves along the ladder by the measured errors. A choice survives small changes of the scene.
// For one bound and one view it returns to settings that failed only if all finer ones failed, and
// converges.
class QualityControl {
 public:
  // Measures to decide whether a scene has changed much.
  using Measures = std::array<double, 6>;

  struct Trial {
    Settings settings;
    std::optional<ErrorEstimate> error;  // latest measurement in this scene
    bool in_other_view = false;
    double milliseconds = 0.0;  // of that frame
  };

  // `settings` provides everything that auto does not choose.
  explicit QualityControl(const Settings& settings = {});

  // The current choice.
  [[nodiscard]] const Settings& settings() const { return trials_[step_].settings; }

  // Bound on the relative RMSE, > 0, compared with the upper end of the confidence interval.
  // Setting it may change the choice at once, from known measurements.
  [[nodiscard]] double max_error() const { return max_error_; }
  void set_max_error(double max_error);

  // Call before each frame: drops errors measured in a very different scene. The choice stays as
  // the starting point.
  void begin_frame(const Scene& scene, const Camera& camera);
  // Drops the choice as well: for another scene.
  void reset();

  // Records the error and time of a frame. Settings outside the ladder are ignored. If the choice
  // changes, the frame should be rendered again.
  void record(const Settings& settings, const ErrorEstimate& error, double milliseconds);

  // All settings in order of cost, and the index of the current choice.
  [[nodiscard]] const std::vector<Trial>& trials() const { return trials_; }
  [[nodiscard]] std::size_t step() const { return step_; }
  // Whether the settings failed the bound in this scene, or may fail it.
  [[nodiscard]] bool broke_bound(const Trial& trial) const;
  // Whether the current choice may meet the bound without being sure to.
  [[nodiscard]] bool may_keep_bound() const { return may_keep_bound(trials_[step_]); }
  // Whether the current choice and the finest both fail the bound.
  [[nodiscard]] bool is_exhausted() const {
    return broke_bound(trials_[step_]) && broke_bound(trials_.back());
  }

 private:
  void move();
  [[nodiscard]] bool may_keep_bound(const Trial& trial) const {
    return trial.error && trial.error->rel_rmse <= max_error_;
  }
  [[nodiscard]] bool may_go_down(double high) const;
  [[nodiscard]] std::size_t finer_step() const;
  [[nodiscard]] std::size_t step_to_settle() const;

  std::vector<Trial> trials_;
  std::size_t step_;
  double max_error_ = Settings{}.max_error;
  // Lights and environment, Gaussians, sum of their optical depths, homogeneous density, at the
  // last reset of errors.
  std::optional<Measures> measures_;
  Camera camera_;
};

}  // namespace brume
