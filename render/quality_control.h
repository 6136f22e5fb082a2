#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/error_estimate.h"
#include "render/settings.h"

namespace brume {

// `auto` for a program that shows one frame after another: renders at once with the present choice,
// measures the frame when there is time, and moves along the ladder by what was measured. A choice
// lasts while the scene changes little. With one bound and one view of a scene it comes back to
// settings that have broken the bound only where all finer ones have, and rests there.
class QualityControl {
 public:
  // What tells whether a scene has changed much.
  using Measures = std::array<double, 5>;

  struct Trial {
    Settings settings;
    std::optional<ErrorEstimate> error;  // the last measured in this scene
    bool in_other_view = false;
    double milliseconds = 0.0;  // of that frame
  };

  // `settings` gives all that auto does not choose.
  explicit QualityControl(const Settings& settings = {});

  // The present choice.
  [[nodiscard]] const Settings& settings() const { return trials_[step_].settings; }

  // The relative RMSE to keep with the upper end of the interval, > 0. Another bound may change the
  // choice at once, by what is known.
  [[nodiscard]] double max_error() const { return max_error_; }
  void set_max_error(double max_error);

  // To be called before each frame: errors measured in a much different scene are forgotten. The
  // choice stays: it is where the search goes on from.
  void follow(const Scene& scene, const Camera& camera);
  // Forgets the choice too: for another scene.
  void forget();

  // Hears the error of a frame that was rendered with `settings` in so many milliseconds; others
  // than the ladder's are ignored. If the choice has changed then, the frame is due again.
  void learn(const Settings& settings, const ErrorEstimate& error, double milliseconds);

  // The whole ladder from cheap to costly, and where on it the choice is.
  [[nodiscard]] const std::vector<Trial>& trials() const { return trials_; }
  [[nodiscard]] std::size_t step() const { return step_; }
  // Whether settings have broken the bound in this scene, or are at least not sure to keep it.
  [[nodiscard]] bool broke_bound(const Trial& trial) const;
  // Whether the present choice may keep the bound, though it is not sure to.
  [[nodiscard]] bool may_keep_bound() const { return may_keep_bound(trials_[step_]); }
  // Whether the present choice breaks it, and even the finest.
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
  double max_error_ = 0.02;
  // Lights and environment, Gaussians, their depths added up, homogeneous density: when errors were
  // last forgotten.
  std::optional<Measures> measures_;
  Camera camera_;
};

}  // namespace brume
