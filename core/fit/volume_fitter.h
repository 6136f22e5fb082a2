#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "brume/density_grid.h"
#include "brume/fit.h"
#include "brume/scene.h"
#include "core/fit/gaussian_numbers.h"
#include "core/fit/volume_appearance.h"
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

// Parameters of fitting a volume.
struct VolumeFit {
  std::string grid = "density";                   // no_grid: none, for flames alone
  FitOptions options;                             // `count` is of smoke and flames together
  double density_scale = 1.0;                     // scattering coefficient of density 1 [1/u]
  bool z_up = false;                              // rotates z to y
  double frames_per_second = default_frame_rate;  // for sequences with velocities
  AppearanceOptions appearance;
  // A preview of one file has few Gaussians at a low resolution, fitted in a few steps.
  bool is_preview = false;
};

struct FittedVolume {
  DensityGrid grid;         // of the density, as fitted
  Fit fit;                  // of the density, with optics if the volume has some
  std::size_t renewed = 0;  // Gaussians without a predecessor in the previous frame, of all
  std::optional<Fit> flames;
  OpticsErrors errors;  // of the optics of `fit`

  // Those of the density, then those of the flames.
  [[nodiscard]] std::vector<Gaussian> gaussians() const;
};

inline constexpr std::size_t max_fitted_blocks = 200'000;
inline constexpr double fit_bytes_per_block = 6e3;  // of memory, about

// Fits one OpenVDB file, or those of a sequence in order, each starting from the previous frame's
// advected Gaussians. Grids of more than 200,000 blocks are downsampled by two until they fit.
// Flames become Gaussians of their own: their share of the count is their share of the blocks.
class VolumeFitter {
 public:
  explicit VolumeFitter(VolumeFit how) : how_(std::move(how)) {}

  // nullopt when it was stopped. Throws InputError.
  std::optional<FittedVolume> next(const std::filesystem::path& file,
                                   const std::stop_token& stop = {},
                                   const std::function<void(double)>& progress = {});

  // Persistent ids of the last frame's Gaussians.
  [[nodiscard]] std::span<const GaussianNumber> ids() const { return ids_; }

 private:
  VolumeFit how_;
  SequenceFitter smoke_;
  SequenceFitter flames_;
  std::filesystem::path last_file_;  // of the previous frame
  GaussianNumber counter_ = 0;
  std::vector<GaussianNumber> ids_;
};

}  // namespace brume
