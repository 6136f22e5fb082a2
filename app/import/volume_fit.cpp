#include "app/import/volume_fit.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <numeric>

#include "core/fit/gaussian_numbers.h"
#include "core/io/volume_file.h"

namespace brume {
namespace {

// As brume fit: above this a grid is fitted at half its resolution.
constexpr std::size_t most_blocks = 200'000;

DensityGrid read(const std::filesystem::path& file, const VolumeFit& how) {
  DensityGrid grid = read_volume(file, how.grid);
  while (grid.blocks.size() > most_blocks) grid = coarser(grid);
  for (DensityGrid::Block& block : grid.blocks) {
    for (float& value : block.values) value *= static_cast<float>(how.density_scale);
  }
  if (how.z_up) {
    const glm::dquat turn = glm::angleAxis(glm::radians(-90.0), glm::dvec3(1.0, 0.0, 0.0));
    grid.rotation = turn * grid.rotation;
    grid.origin = turn * grid.origin;
  }
  return grid;
}

SequenceFrame to_frame(const std::vector<Gaussian>& gaussians,
                       std::span<const GaussianNumber> ids) {
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  SequenceFrame frame;
  for (const std::size_t i : order) {
    frame.ids.push_back(ids[i]);
    frame.gaussians.push_back(gaussians[i]);
  }
  return frame;
}

}  // namespace

std::optional<std::vector<Gaussian>> fit_volume(const std::filesystem::path& file,
                                                const VolumeFit& how, const Job& job) {
  auto fit = fit_gaussians(read(file, how), how.options, job.stop, job.progress);
  if (!fit) return std::nullopt;
  return std::move(fit->gaussians);
}

std::vector<SequenceFrame> fit_volumes(const std::vector<std::filesystem::path>& files,
                                       const VolumeFit& how, const Job& job) {
  std::vector<SequenceFrame> frames;
  std::vector<Gaussian> last;
  GaussianNumbers numbers;
  for (std::size_t k = 0; k < files.size() && !job.stop.stop_requested(); ++k) {
    const double count = static_cast<double>(files.size());
    const Job part = job.part(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
    const DensityGrid grid = read(files[k], how);
    if (last.empty() || grid.blocks.empty()) {
      auto fit = fit_gaussians(grid, how.options, part.stop, part.progress);
      if (!fit) break;
      last = std::move(fit->gaussians);
      numbers.begin(last.size());
    } else {
      auto refit = refit_gaussians(grid, last, part.stop, part.progress);
      if (!refit) break;
      last = std::move(refit->fit.gaussians);
      numbers.renew(refit->renewed);
    }
    frames.push_back(to_frame(last, numbers.ids()));
  }
  return frames;
}

}  // namespace brume
