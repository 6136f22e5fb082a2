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
// lasts while the scene changes little. With one bound and one view of a scene it never comes back
// to settings that have broken the bound, so it comes to rest.
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
  // Whether settings have broken the bound in this scene.
  [[nodiscard]] bool broke_bound(const Trial& trial) const;
  // Whether even the finest settings break it.
  [[nodiscard]] bool is_exhausted() const {
    return step_ + 1 == trials_.size() && broke_bound(trials_.back());
  }

 private:
  void move();
  [[nodiscard]] bool may_go_down(double high) const;

  std::vector<Trial> trials_;
  std::size_t step_;
  double max_error_ = 0.02;
  // Lights and environment, Gaussians, their depths added up, homogeneous density: when errors were
  // last forgotten.
  std::optional<Measures> measures_;
  Camera camera_;
};

}  // namespace brume
