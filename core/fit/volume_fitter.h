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

// Parameters of fitting a volume.
struct VolumeFit {
  std::string grid = "density";
  FitOptions options;
  double density_scale = 1.0;       // scattering coefficient of density 1 [1/u]
  bool z_up = false;                // rotates z to y
  double frames_per_second = 30.0;  // for sequences with velocities
};

struct FittedVolume {
  DensityGrid grid;  // as fitted
  Fit fit;
  std::size_t renewed = 0;  // Gaussians without a predecessor in the previous frame
};

// Fits one OpenVDB file, or those of a sequence in order, each starting from the previous frame's
// advected Gaussians. Grids of more than 200,000 blocks are downsampled by two until they fit.
class VolumeFitter {
 public:
  explicit VolumeFitter(VolumeFit how) : how_(std::move(how)) {}

  // nullopt when it was stopped. Throws InputError.
  std::optional<FittedVolume> next(const std::filesystem::path& file,
                                   const std::stop_token& stop = {},
                                   const std::function<void(double)>& progress = {});

  // Persistent ids of the last frame's Gaussians.
  [[nodiscard]] std::span<const GaussianNumber> ids() const { return numbers_.ids(); }

 private:
  VolumeFit how_;
  std::vector<Gaussian> last_;  // previous frame
  std::filesystem::path last_file_;
  GaussianNumbers numbers_;
};

}  // namespace brume
