#include "core/fit/volume_fitter.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "brume/error.h"
#include "core/fit/fit_start.h"
#include "core/io/volume/volume_file.h"

namespace brume {
namespace {

// A preview is fitted in a moment.
constexpr std::size_t max_preview_blocks = 250;
constexpr std::size_t max_preview_count = 500;

std::size_t max_blocks(const VolumeFit& how) {
  return how.is_preview ? max_preview_blocks : max_fitted_blocks;
}

// The rotation from the volume's axes to ours.
glm::dquat turn(const VolumeFit& how) {
  return how.z_up ? glm::angleAxis(glm::radians(-90.0), glm::dvec3(1.0, 0.0, 0.0))
                  : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

// Turned, times `scale`.
DensityGrid prepared(DensityGrid grid, double scale, const VolumeFit& how) {
  for (DensityGrid::Block& block : grid.blocks) {
    for (float& value : block.values) value *= static_cast<float>(scale);
  }
  rotate(grid, turn(how));
  return grid;
}

DensityGrid read_density(const std::filesystem::path& file, const VolumeFit& how) {
  if (how.grid == no_grid) return {};
  return prepared(at_most(read_volume(file, how.grid), max_blocks(how)), how.density_scale, how);
}

VolumeOptics read_optics(const std::filesystem::path& file, const VolumeFit& how) {
  const AppearanceOptions& appearance = how.appearance;
  VolumeOptics optics =
      read_volume_optics(file, appearance.grids, appearance.temperature_scale, max_blocks(how));
  for (std::optional<FieldGrid>* field : {&optics.color, &optics.emission, &optics.temperature}) {
    if (*field) rotate(**field, turn(how));
  }
  if (optics.flame) {
    optics.flame = prepared(std::move(*optics.flame), appearance.flame_scale, how);
  }
  return optics;
}

// The share of the blocks of both that has flames.
double flame_share(const DensityGrid& smoke, const DensityGrid& flame) {
  const auto blocks = static_cast<double>(smoke.blocks.size());
  const auto flame_blocks = static_cast<double>(flame.blocks.size());
  return flame_blocks > 0.0 ? flame_blocks / (blocks + flame_blocks) : 0.0;
}

// At least one of each that there is, if `count` allows.
std::size_t flame_count(std::size_t count, double share) {
  const auto flames = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
  return share < 1.0 && count > 1 ? std::min(flames, count - 1) : flames;
}

// Extinctions become densities.
void make_flames(Fit& fit, const DensityGrid& extinction, const OpticsTargets& targets) {
  fit_optics(extinction, targets, fit.gaussians);
  for (Gaussian& gaussian : fit.gaussians) {
    gaussian.density *= flame_albedo;
    gaussian.optics.albedo = glm::dvec3(flame_albedo);
  }
}

}  // namespace

std::vector<Gaussian> FittedVolume::gaussians() const {
  std::vector<Gaussian> all = fit.gaussians;
  if (flames) all.insert(all.end(), flames->gaussians.begin(), flames->gaussians.end());
  return all;
}

std::optional<FittedVolume> VolumeFitter::next(const std::filesystem::path& file,
                                               const std::stop_token& stop,
                                               const std::function<void(double)>& progress) {
  FittedVolume fitted;
  fitted.grid = read_density(file, how_);
  const VolumeOptics optics = read_optics(file, how_);
  const DensityGrid flame = optics.flame.value_or(DensityGrid());
  if (how_.grid == no_grid && !optics.flame) {
    throw InputError(file, "", "has no flames; allowed without a density: a grid of flames");
  }
  std::optional<VelocityGrid> velocity;
  if (smoke_.is_running() || flames_.is_running()) velocity = read_velocity(last_file_);
  if (velocity) rotate(*velocity, turn(how_));
  const double seconds = 1.0 / how_.frames_per_second;

  const double share = flame_share(fitted.grid, flame);
  FitOptions smoke_options = how_.options;
  FitOptions flame_options = how_.options;
  if (how_.is_preview) smoke_options.count = std::min(smoke_options.count, max_preview_count);
  flame_options.count = flame_count(smoke_options.count, share);
  smoke_options.count -= flame_options.count;
  const auto progress_in = [&](double begin, double end) {
    return [&progress, begin, end](double p) {
      if (progress) progress(begin + (end - begin) * p);
    };
  };

  const auto fit = [&](SequenceFitter& fitter, const DensityGrid& grid, const FitOptions& options,
                       const std::function<void(double)>& progressed) {
    if (!how_.is_preview) {
      return fitter.next(grid, options, velocity, seconds, counter_, stop, progressed);
    }
    auto preview = fit_preview(grid, options, stop);
    return preview ? std::optional(SequenceFitter::Next{std::move(*preview)}) : std::nullopt;
  };

  auto smoke = fit(smoke_, fitted.grid, smoke_options, progress_in(0.0, 1.0 - share));
  if (!smoke) return std::nullopt;
  fitted.fit = std::move(smoke->fit);
  fitted.renewed = smoke->renewed;
  fitted.errors = fit_optics(
      fitted.grid, smoke_targets(fitted.grid, how_.density_scale, optics, how_.appearance),
      fitted.fit.gaussians);
  auto flames = fit(flames_, flame, flame_options, progress_in(1.0 - share, 1.0));
  if (!flames) return std::nullopt;
  if (!flames->fit.gaussians.empty()) {
    fitted.flames = std::move(flames->fit);
    fitted.renewed += flames->renewed;
    make_flames(*fitted.flames, flame, flame_targets(flame, optics, how_.appearance));
  }
  ids_.assign(smoke_.ids().begin(), smoke_.ids().end());
  ids_.insert(ids_.end(), flames_.ids().begin(), flames_.ids().end());
  last_file_ = file;
  return fitted;
}

std::optional<SequenceFitter::Next> SequenceFitter::next(
    const DensityGrid& grid, const FitOptions& options, const std::optional<VelocityGrid>& velocity,
    double seconds, GaussianNumber& counter, const std::stop_token& stop,
    const std::function<void(double)>& progress) {
  Next next;
  if (last_.empty() || grid.blocks.empty()) {
    auto fit = fit_gaussians(grid, options, stop, progress);
    if (!fit) return std::nullopt;
    next.fit = std::move(*fit);
    numbers_.begin(next.fit.gaussians.size(), counter);
  } else {
    if (velocity) last_ = next_start(grid, last_, *velocity, seconds);
    auto refit = refit_gaussians(grid, last_, stop, progress);
    if (!refit) return std::nullopt;
    next.fit = std::move(refit->fit);
    next.renewed = numbers_.relocate(refit->renewed, counter);
  }
  last_ = next.fit.gaussians;
  return next;
}

}  // namespace brume
