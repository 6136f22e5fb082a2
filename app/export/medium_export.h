#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/jobs/background_job.h"
#include "brume/scene.h"
#include "brume/splat.h"

namespace brume {

// The formats that Gaussians are exported in.
enum class MediumFormat : std::uint8_t {
  volume,      // .vdb, grids as write_volume() names them
  gaussians,   // .ply, .csv
  splats,      // .ply, .glb, .gltf
  lit_splats,  // .ply, as lit_splat_file() writes it
  page,        // .html, too
  stage        // .usda of the scene: the fog as splats and, in a .vdb beside it, as a volume
};

// Parameters of exporting a scene's Gaussians. The homogeneous density is unbounded and excluded.
struct MediumExport {
  std::shared_ptr<const Scene> scene;  // with all its times
  // Only these Gaussians of it, sorted; nullopt: all, and those of emitters and sequences.
  std::optional<std::vector<GaussianId>> only;
  std::filesystem::path file;
  MediumFormat format = MediumFormat::volume;
  double voxel_size = 0.0;                  // of a .vdb; 0: half the least radius
  bool half = false;                        // a .vdb in half precision
  OpacityAlong along = OpacityAlong::mean;  // of splats
  bool y_down = false;                      // of splats of a .ply
  double exposure = 0.0;                    // of lit ones [stops]
  double time = 0.0;                        // [s]
  // Frames of the timeline instead, into numbered files; of a stage only its volumes are.
  struct Range {
    int first = 0;
    int last = 0;
    double frames_per_second = default_frame_rate;
  };
  std::optional<Range> range;
};

// Removes all other Gaussians of a medium; `ids` are sorted.
void keep_only(Medium& medium, const std::vector<GaussianId>& ids);

// Maximum size of a grid [bytes].
inline constexpr std::uintmax_t max_grid_bytes = std::uintmax_t{2} << 30;
// Memory of a medium's grid; nullopt beyond the maximum. voxel_size: see MediumExport.
std::optional<std::uintmax_t> grid_bytes(const Medium& medium, double voxel_size);

// The background work of an export. Files are written atomically; complete ones of a cancelled
// range stay.
BackgroundJob::Work export_medium(const MediumExport& request);

}  // namespace brume
