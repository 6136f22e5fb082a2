#include "core/fit/volume_fitter.h"

#include <glm/gtc/quaternion.hpp>

#include "core/fit/next_start.h"
#include "core/io/volume/volume_file.h"

namespace brume {
namespace {

// The fit needs about 6 kB of memory per block.
constexpr std::size_t max_blocks = 200'000;

// What turns the volume's axes into ours.
glm::dquat turn(const VolumeFit& how) {
  return how.z_up ? glm::angleAxis(glm::radians(-90.0), glm::dvec3(1.0, 0.0, 0.0))
                  : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

DensityGrid read(const std::filesystem::path& file, const VolumeFit& how) {
  DensityGrid grid = read_volume(file, how.grid);
  while (grid.blocks.size() > max_blocks) grid = coarser(grid);
  for (DensityGrid::Block& block : grid.blocks) {
    for (float& value : block.values) value *= static_cast<float>(how.density_scale);
  }
  rotate(grid, turn(how));
  return grid;
}

}  // namespace

std::optional<FittedVolume> VolumeFitter::next(const std::filesystem::path& file,
                                               const std::stop_token& stop,
                                               const std::function<void(double)>& progress) {
  FittedVolume fitted{read(file, how_), {}, 0};
  if (last_.empty() || fitted.grid.blocks.empty()) {
    auto fit = fit_gaussians(fitted.grid, how_.options, stop, progress);
    if (!fit) return std::nullopt;
    fitted.fit = std::move(*fit);
    numbers_.begin(fitted.fit.gaussians.size());
  } else {
    if (auto velocity = read_velocity(last_file_)) {
      rotate(*velocity, turn(how_));
      last_ = next_start(fitted.grid, last_, *velocity, 1.0 / how_.frames_per_second);
    }
    auto refit = refit_gaussians(fitted.grid, last_, stop, progress);
    if (!refit) return std::nullopt;
    fitted.fit = std::move(refit->fit);
    fitted.renewed = numbers_.relocate(refit->renewed);
  }
  last_ = fitted.fit.gaussians;
  last_file_ = file;
  return fitted;
}

}  // namespace brume
