#include "app/export/medium_export.h"

#include <algorithm>
#include <iterator>

#include "app/export/export_frames.h"
#include "app/files/numbered_file.h"
#include "brume/at_time.h"
#include "brume/edits.h"
#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/scene/usd_file.h"
#include "core/io/volume/volume_file.h"
#include "core/number_domain.h"
#include "core/volume/medium_grid.h"
#include "render/splats/lit_splat_file.h"

namespace brume {
namespace {

constexpr std::size_t max_blocks = max_grid_bytes / sizeof(DensityGrid::Block);

double chosen_voxel_size(const Medium& medium, double request) {
  const double size = request > 0.0 ? request : fitting_voxel_size(medium);
  return size > 0.0 ? size : 1.0;  // nothing to sample
}

Scene exported_scene(const MediumExport& request, double time) {
  Scene scene = evaluate_at(*request.scene, time);
  if (request.only) keep_only(scene.medium, *request.only);
  return scene;
}

struct Grids {
  DensityGrid density;
  VolumeColors colors;
};

Grids sampled(const MediumExport& request, const std::filesystem::path& file, const Scene& scene,
              const Job& job) {
  const double size = chosen_voxel_size(scene.medium, request.voxel_size);
  const auto plan = MediumSampling::plan(scene.medium, size, max_blocks);
  if (!plan) {
    const auto sufficient = sufficient_voxel_size(scene.medium, size, max_blocks);
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
  return {std::move(*density), std::move(*colors)};
}

// Returns a function that writes the medium of a time to a file. Throws Cancelled.
FrameLoop::Write writing(const MediumExport& request, const std::filesystem::path& file,
                         double time, const Job& job) {
  const Scene scene = exported_scene(request, time);
  switch (request.format) {
    case MediumFormat::volume:
      return [grids = std::make_shared<const Grids>(sampled(request, file, scene, job)), file,
              half = request.half] { write_volume(file, grids->density, half, grids->colors); };
    case MediumFormat::splats:
      return [gaussians = scene.medium.gaussians(), ids = written_ids(scene.medium), file,
              output = SplatOutput{request.along, scene.optics.albedo, {}, request.y_down}] {
        SplatOutput with_ids = output;
        with_ids.ids = ids;
        write_splats(file, gaussians, with_ids);
      };
    case MediumFormat::lit_splats:
    case MediumFormat::page: {
      auto bytes = lit_splat_file(evaluate_at(*request.scene, time),
                                  {request.exposure, request.along, request.y_down, request.only},
                                  file, job);
      if (!bytes) throw Cancelled();
      return [bytes = std::move(*bytes), file] { write_atomically(file, bytes); };
    }
    case MediumFormat::gaussians:
    case MediumFormat::stage:  // write_stage() has all its frames
      break;
  }
  return [gaussians = scene.medium.gaussians(), ids = written_ids(scene.medium), file] {
    write_gaussians(file, gaussians, ids);
  };
}

void write_stage(const MediumExport& request, const Job& job) {
  const MediumExport::Range range = request.range.value_or(MediumExport::Range{});
  FileGroup group;
  std::vector<UsdFrame> frames;
  const int count = range.last - range.first + 1;
  for (int k = 0; k < count; ++k) {
    const int number = range.first + k;
    const double time = request.range ? number / range.frames_per_second : request.time;
    UsdFrame& frame = frames.emplace_back();
    if (request.range) frame.frame = number;
    frame.scene = exported_scene(request, time);
    frame.splats = frame.scene.medium.gaussians();
    if (frame.splats.empty()) continue;
    const std::filesystem::path file = volume_of_stage(request.file, frame.frame);
    const Grids grids = sampled(request, file, frame.scene,
                                job.subrange(static_cast<double>(k) / count, (k + 1.0) / count));
    write_volume(file, grids.density, request.half, grids.colors);
    replace_medium(frame, file, grids.colors);
  }
  if (job.stop.stop_requested()) throw Cancelled();
  write_usd(request.file, frames, range.frames_per_second, request.along);
  group.commit();
}

}  // namespace

void keep_only(Medium& medium, const std::vector<GaussianId>& ids) {
  std::vector<GaussianId> others;
  std::ranges::set_difference(medium.ids(), ids, std::back_inserter(others));
  MediumEdit::remove(medium, others).apply(medium);
}

std::optional<std::uintmax_t> grid_bytes(const Medium& medium, double voxel_size) {
  const auto plan = MediumSampling::plan(medium, chosen_voxel_size(medium, voxel_size), max_blocks);
  if (!plan) return std::nullopt;
  return plan->bytes();
}

BackgroundJob::Work export_medium(const MediumExport& request) {
  return [request](const Job& job) -> BackgroundJob::Apply {
    if (request.format == MediumFormat::stage) {
      write_stage(request, job);
      return {};
    }
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
