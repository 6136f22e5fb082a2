#include "app/medium_export.h"

#include "app/frame_export.h"
#include "core/error.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussian_file.h"
#include "core/io/number_domain.h"
#include "core/io/volume_file.h"
#include "core/scene/at_time.h"
#include "core/volume/medium_grid.h"

namespace brume {
namespace {

constexpr std::size_t most_blocks = most_grid_bytes / sizeof(DensityGrid::Block);

double chosen_voxel_size(const Medium& medium, double wanted) {
  const double size = wanted > 0.0 ? wanted : fitting_voxel_size(medium);
  return size > 0.0 ? size : 1.0;  // nothing to sample
}

// Whether it was written.
bool write(const MediumExport& wanted, const std::filesystem::path& file, double time,
           const Job& job) {
  const Scene scene = at_time(*wanted.scene, time);
  const Medium& medium = scene.medium;
  if (lower_case_extension(file) != ".vdb") {
    std::vector<Gaussian> gaussians;
    for (std::size_t i = 0; i < medium.size(); ++i) gaussians.push_back(medium.gaussian(i));
    write_gaussians(file, gaussians);
    return true;
  }
  const double size = chosen_voxel_size(medium, wanted.voxel_size);
  const auto plan = MediumSampling::plan(medium, size, most_blocks);
  if (!plan) {
    const auto sufficient = sufficient_voxel_size(medium, size, most_blocks);
    throw InputError(file, "",
                     "a grid with voxels of " + shown(size) + " needs more than 2 GB; allowed: " +
                         (sufficient ? "voxels of " + shown(*sufficient) + " or more"
                                     : std::string("larger voxels")));
  }
  const auto grid = plan->sample(job.stop, job.progress);
  if (!grid) return false;
  write_volume(file, *grid, wanted.half);
  return true;
}

}  // namespace

std::optional<std::uintmax_t> grid_bytes(const Medium& medium, double voxel_size) {
  const auto plan =
      MediumSampling::plan(medium, chosen_voxel_size(medium, voxel_size), most_blocks);
  if (!plan) return std::nullopt;
  return plan->bytes();
}

BackgroundJob::Work export_medium(const MediumExport& wanted) {
  return [wanted](const Job& job) -> BackgroundJob::Take {
    if (!wanted.range) {
      write(wanted, wanted.file, wanted.time, job);
      return {};
    }
    const MediumExport::Range& range = *wanted.range;
    const double count = range.last - range.first + 1;
    for (int frame = range.first; frame <= range.last && !job.stop.stop_requested(); ++frame) {
      const double k = frame - range.first;
      write(wanted, numbered_file(wanted.file, frame), frame / range.frames_per_second,
            job.part(k / count, (k + 1.0) / count));
    }
    return {};
  };
}

}  // namespace brume
