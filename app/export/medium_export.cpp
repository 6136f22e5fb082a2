#include "app/export/medium_export.h"

#include "app/export/frame_export.h"
#include "brume/at_time.h"
#include "brume/error.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/volume/volume_file.h"
#include "core/number_domain.h"
#include "core/volume/medium_grid.h"

namespace brume {
namespace {

constexpr std::size_t max_blocks = max_grid_bytes / sizeof(DensityGrid::Block);

double chosen_voxel_size(const Medium& medium, double request) {
  const double size = request > 0.0 ? request : fitting_voxel_size(medium);
  return size > 0.0 ? size : 1.0;  // nothing to sample
}

// Whether it was written.
bool write(const MediumExport& request, const std::filesystem::path& file, double time,
           const Job& job) {
  const Scene scene = evaluate_at(*request.scene, time);
  const Medium& medium = scene.medium;
  if (lower_case_extension(file) != ".vdb") {
    std::vector<Gaussian> gaussians;
    for (std::size_t i = 0; i < medium.size(); ++i) gaussians.push_back(medium.gaussian(i));
    write_gaussians(file, gaussians);
    return true;
  }
  const double size = chosen_voxel_size(medium, request.voxel_size);
  const auto plan = MediumSampling::plan(medium, size, max_blocks);
  if (!plan) {
    const auto sufficient = sufficient_voxel_size(medium, size, max_blocks);
    throw InputError(file, "",
                     "a grid with voxels of " + quoted_text(size) +
                         " needs more than 2 GB; allowed: " +
                         (sufficient ? "voxels of " + quoted_text(*sufficient) + " or more"
                                     : std::string("larger voxels")));
  }
  const Job density_job = job.subrange(0.0, 0.5);
  const Job color_job = job.subrange(0.5, 1.0);
  const auto density = plan->sample(density_job.stop, density_job.progress);
  if (!density) return false;
  const auto colors = plan->sample_colors(scene.optics.albedo, color_job.stop, color_job.progress);
  if (!colors) return false;
  write_volume(file, *density, request.half, *colors);
  return true;
}

}  // namespace

std::optional<std::uintmax_t> grid_bytes(const Medium& medium, double voxel_size) {
  const auto plan = MediumSampling::plan(medium, chosen_voxel_size(medium, voxel_size), max_blocks);
  if (!plan) return std::nullopt;
  return plan->bytes();
}

BackgroundJob::Work export_medium(const MediumExport& request) {
  return [request](const Job& job) -> BackgroundJob::Apply {
    if (!request.range) {
      write(request, request.file, request.time, job);
      return {};
    }
    const MediumExport::Range& range = *request.range;
    const double count = range.last - range.first + 1;
    for (int frame = range.first; frame <= range.last && !job.stop.stop_requested(); ++frame) {
      const double k = frame - range.first;
      write(request, numbered_file(request.file, frame), frame / range.frames_per_second,
            job.subrange(k / count, (k + 1.0) / count));
    }
    return {};
  };
}

}  // namespace brume
