#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/fit/gaussian_fit.h"
#include "core/fit/gaussian_numbers.h"
#include "core/volume/density_grid.h"
#include "core/volume/velocity_grid.h"

namespace brume {

// How a volume becomes Gaussians.
struct VolumeFit {
  std::string grid = "density";
  FitOptions options;
  double density_scale = 1.0;       // what a density of 1 scatters [1/u]
  bool z_up = false;                // z is turned to y
  double frames_per_second = 30.0;  // of a sequence whose volumes have velocities
};

struct FittedVolume {
  DensityGrid grid;  // as it was fitted
  Fit fit;
  std::size_t renewed = 0;  // Gaussians that did not go on from the frame before
};

// Fits the OpenVDB files of a sequence one after the other, or just one: each frame starts from the
// Gaussians of the one before, moved with its velocity. A grid of more than 200,000 blocks is
// fitted at half its resolution, again and again.
class VolumeFitter {
 public:
  explicit VolumeFitter(VolumeFit how) : how_(std::move(how)) {}

  // nullopt when it was stopped. Throws InputError.
  std::optional<FittedVolume> next(const std::filesystem::path& file,
                                   const std::stop_token& stop = {},
                                   const std::function<void(double)>& progress = {});

  // Of the last frame, one for each Gaussian; each keeps its own from frame to frame.
  [[nodiscard]] std::span<const GaussianNumber> ids() const { return numbers_.ids(); }

 private:
  VolumeFit how_;
  std::vector<Gaussian> last_;  // of the frame before, and what moves them
  std::filesystem::path last_file_;
  GaussianNumbers numbers_;
};

}  // namespace brume
