#include "app/export/medium_export.h"

#include "app/export/export_frames.h"
#include "app/files/numbered_file.h"
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

// What writes the medium of a time to a file. Throws Cancelled.
FrameLoop::Write writing(const MediumExport& request, const std::filesystem::path& file,
                         double time, const Job& job) {
  const Scene scene = evaluate_at(*request.scene, time);
  const Medium& medium = scene.medium;
  if (lower_case_extension(file) != ".vdb") {
    std::vector<Gaussian> gaussians;
    for (std::size_t i = 0; i < medium.size(); ++i) gaussians.push_back(medium.gaussian(i));
    return [gaussians = std::move(gaussians), file] { write_gaussians(file, gaussians); };
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
  auto density = plan->sample(density_job.stop, density_job.progress);
  if (!density) throw Cancelled();
  auto colors = plan->sample_colors(scene.optics.albedo, color_job.stop, color_job.progress);
  if (!colors) throw Cancelled();
  const auto grids = std::make_shared<const std::pair<DensityGrid, VolumeColors>>(
      std::move(*density), std::move(*colors));
  return
      [grids, file, half = request.half] { write_volume(file, grids->first, half, grids->second); };
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
      writing(request, request.file, request.time, job)();
      return {};
    }
    const MediumExport::Range& range = *request.range;
    export_frames(range.first, range.last, job, [&](int frame, int k, int count) {
      return writing(request, numbered_file(request.file, frame), frame / range.frames_per_second,
                     job.subrange(static_cast<double>(k) / count, (k + 1.0) / count));
    });
    return {};
  };
}

}  // namespace brume
